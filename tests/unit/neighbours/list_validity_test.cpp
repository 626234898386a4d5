// SPDX-License-Identifier: Apache-2.0
// A list that is reported as valid has every pair within reach for any motion of the particles,
// against all pairs; and it is valid for the expected time.
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>

#include "support/loaded.hpp"
#include "support/mirrored.hpp"
#include "support/mixture.hpp"

namespace kerf::test {
namespace {

constexpr double list_skin = 5e-4, width = 0.06;  // m
using Motion =
    std::function<Vector3(const Vector3&, double)>;  // displacement at a position and time

template <int D>
struct Flight {
  ReferenceState state;
  Loaded<D, Double> loaded;
  std::vector<Vector3> start;
  MirrorPlanes<D> mirrors{};

  Flight(const ReferenceState& from, const std::string& faces)
      : state(from), loaded(from, {0.0, width, list_skin}), mirrors(planes_of<D>(faces, width)) {
    loaded.particles.mirrors = mirrors;
    loaded.rebuild();
    for (const auto& particle : state.particles) start.push_back(particle.position);
  }
  // Moves all particles, and reports the displacement to the list; without `notes` the list must
  // check the positions.
  void move(const Motion& motion, double time, bool notes) {
    const auto place = loaded.places();
    MotionSquares moved;
    for (std::size_t k = 0; k < start.size(); ++k) {
      auto& particle = state.particles[k];
      particle.position = start[k] + motion(start[k], time);
      const auto i = static_cast<Index>(place[k]);
      loaded.particles.start_position[i] = loaded.particles.position[i];
      loaded.particles.position[i] = Vector<D, double>::from(particle.position);
      loaded.particles.velocity[i] = Vector<D, double>::zero();
      moved.include(loaded.particles.view(), i);
    }
    loaded.list.note(notes ? moved.roots() : StepMotion{1e300, 1e300});
  }
  using Entries = std::set<std::tuple<std::size_t, std::size_t, MirrorCode>>;

  Entries entries() const {
    const auto id = to_host(loaded.particles.id);
    const NeighbourView view = loaded.list.view();
    Entries listed;
    for (std::size_t i = 0; i < id.size(); ++i)
      for (Index n = view.begin[i]; n < view.end[i]; ++n)
        listed.insert(
            {id[i], id[mirrors.particle(view.neighbour[n])], mirrors.code(view.neighbour[n])});
    return listed;
  }
  Entries listed_images() const {
    Entries listed = entries();
    std::erase_if(listed, [](const auto& entry) { return std::get<2>(entry) == 0; });
    return listed;
  }
  // Returns the pairs within reach that are not in the list.
  int missing() const {
    const auto id = to_host(loaded.particles.id);
    const Entries listed = entries();
    int result = 0;
    for (const MirrorCode code : images_of(mirrors)) {
      std::vector<Vector3> image;
      for (const auto& particle : state.particles)
        image.push_back(mirrored_place(mirrors, code, particle.position));
      for (std::size_t i = 0; i < id.size(); ++i)
        for (std::size_t j = 0; j < id.size(); ++j)
          result +=
              (i != j || code != 0) && sees(i, j, image[j]) && listed.count({i, j, code}) == 0;
    }
    return result;
  }
  bool sees(std::size_t i, std::size_t j, const Vector3& image_of_j) const {
    const double reach = state.medium(i).smoothing_length + state.medium(j).smoothing_length;
    return (state.particles[i].position - image_of_j).squaredNorm() < reach * reach;
  }
};

template <class Dimension>
class ListValidity : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;

  // Moves in small steps until the list is not valid; until then it must have every pair. Returns
  // the distance moved.
  static double last(const Motion& motion, double step, bool notes, const std::string& faces = "") {
    Flight<D> flight(spread_mixture(D, 3, width), faces);
    EXPECT_EQ(flight.missing(), 0);
    for (int n = 1; n < 2000; ++n) {
      flight.move(motion, n * step, notes);
      if (flight.loaded.list.is_outdated(flight.loaded.particles, 0.0)) return n * step;
      if (n % 7 != 0) continue;
      EXPECT_EQ(flight.missing(), 0) << "after " << n;
    }
    return 1e300;
  }
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ListValidity, Dimensions);

// Particles in common motion keep their neighbours, up to half of the range and the skin.
TYPED_TEST(ListValidity, LastsLongForUniformMotion) {
  const Motion flight = [](const Vector3&, double t) { return Vector3(0.6 * t, 0.8 * t, 0.0); };
  const double longest = TestFixture::last(flight, 1e-4, true);
  EXPECT_GT(longest, 5.0 * list_skin);
  EXPECT_LT(longest, 1e300);
}

// The list is valid for vortices, shear and jitter, for any query, and with or without notes of the
// steps.
TYPED_TEST(ListValidity, HasEveryPair) {
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int kind = 0; kind < 6; ++kind) {
    const Vector3 k(300.0 * uniform(engine), 300.0 * uniform(engine), 0.0);
    const double rate = 40.0 * uniform(engine);
    const Motion motion = [k, rate](const Vector3& x, double t) {
      const double wave = std::sin(k.dot(x));
      return Vector3(t * (1.0 + 0.3 * wave), t * (rate * x[0] + 0.1 * wave), 0.0);
    };
    const double plain = TestFixture::last(motion, 2e-5, false);
    EXPECT_LT(plain, 1e300);
    EXPECT_EQ(TestFixture::last(motion, 2e-5, true), plain);
  }
}

// Particles move towards and along symmetry planes, where they meet their images.
TYPED_TEST(ListValidity, IncludesMirrorImages) {
  for (const double angle : {0.0, 0.7, 1.57, 2.5, 3.9, 5.2}) {
    const Motion motion = [angle](const Vector3&, double t) {
      return Vector3(t * std::cos(angle), t * std::sin(angle), 0.0);
    };
    const double longest = TestFixture::last(motion, 2e-5, true, "x- y+");
    EXPECT_LT(longest, 3.0 * list_skin) << angle;  // they approach at twice the speed
    EXPECT_EQ(longest, TestFixture::last(motion, 2e-5, false, "x- y+"));
  }
}

// Solid particles can cross a plane. Beyond it, too, one that has the image of another in its list
// is in the list of that other.
TYPED_TEST(ListValidity, ImagesSeeEachOtherAlsoBeyondAPlane) {
  constexpr int dimension = TestFixture::D;
  ReferenceState state = spread_mixture(dimension, 3, width);
  double crossed = 0.0;
  for (auto& particle : state.particles) {
    particle.position[0] -= 0.1 * width;
    crossed = std::min(crossed, particle.position[0]);
  }
  EXPECT_LT(crossed, -0.04 * width);
  const Flight<dimension> flight(state, "x-");
  const auto images = flight.listed_images();
  EXPECT_GT(images.size(), 10u);
  for (const auto& [i, j, code] : images)
    EXPECT_EQ(images.count({j, i, code}), 1u) << i << " and " << j;
}

// Two bodies out of reach of one another when the list is built, one of them fast.
TYPED_TEST(ListValidity, IncludesFastDistantParticles) {
  const Motion motion = [](const Vector3& x, double t) {
    return x[0] > 0.6 * width ? Vector3(-t, 0.0, 0.0) : Vector3(0.0, 0.0, 0.0);
  };
  constexpr int dimension = TestFixture::D;
  ReferenceState state = spread_mixture(dimension, 5, width);
  std::erase_if(state.particles, [](const auto& particle) {
    return particle.position[0] > 0.3 * width && particle.position[0] < 0.7 * width;
  });
  Flight<dimension> flight(state, "");
  int built = 0;
  for (int n = 1; n < 600; ++n) {
    flight.move(motion, n * 5e-5, true);
    if (flight.loaded.list.is_outdated(flight.loaded.particles, 0.0)) {
      flight.loaded.rebuild();
      ++built;
    }
    if (n % 20 != 0) continue;
    ASSERT_EQ(flight.missing(), 0) << "after " << n;
  }
  EXPECT_GT(built, 2);
}

}  // namespace
}  // namespace kerf::test
