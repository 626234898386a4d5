// SPDX-License-Identifier: Apache-2.0
// A plane rigid wall that a lattice fills acts on a particle of water as layers parallel to its
// surface do, whatever the angle between surface and lattice.
#include "fluid/smooth_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/standard_mixture.hpp"
#include "time/verlet.hpp"

namespace kerf::test::smooth_wall_test {
namespace {

constexpr double spacing = 1e-3, smoothing_length = 1.3 * spacing, centre = 0.01;

// One particle of water at a height above a wall, compressed by 1%.
struct WaterAtWall {
  Vector3 normal = Vector3::UnitY();
  Vector3 velocity = Vector3::Zero();
  Vector3 shift = Vector3::Zero();  // of the lattice
  double height = 0.5 * spacing;
};

template <int D, class P>
class Evaluated {
 public:
  using Real = typename P::Real;

  explicit Evaluated(const WaterAtWall& setup)
      : setup_(setup), loaded_(state(), {0.0, 0.02, 5e-4}) {
    auto& particles = loaded_.particles;
    const auto place = loaded_.places();
    for (std::size_t k = 1; k < place.size(); ++k) {
      particles.face_normal[place[k]] = Vector<D, Real>::from(setup.normal);
      particles.face_depth[place[k]] = Real(-height_of(state_.particles[k].position));
    }
    evaluate_standard<D, P>(state_, loaded_);
    // The normal of the wall is known after one step, the factors of its sums after two.
    for (int step = 0; step < 2; ++step) {
      for_each_index(particles.size(), UpdateSurfaceFlags<D, P>{particles.view()});
      // The flag of the surface would leave the water room.
      thrust::fill(particles.flags.begin(), particles.flags.end(), std::uint8_t(0));
      evaluate_standard<D, P>(state_, loaded_);
    }
    water_ = place[0];
  }
  Vector3 force() const {
    const Vector<D, double> a =
        Vector<D, double>::from(Vector<D, Real>(loaded_.particles.acceleration[water_]));
    return state_.media[0].mass * as_eigen(a);
  }
  double compression_rate() const { return loaded_.particles.compression_rate[water_]; }
  double kernel_sum() const { return loaded_.particles.kernel_sum[water_]; }
  // The factors of the sums less 1.
  double force_excess() const { return loaded_.particles.wall_force_excess[water_]; }
  double volume_excess() const { return loaded_.particles.wall_volume_excess[water_]; }
  double pressure() const { return loaded_.particles.pressure[water_]; }
  double volume() const { return state_.media[0].mass / 1010.0; }

 private:
  double height_of(const Vector3& x) const {
    const Vector3 water(centre, centre, D == 3 ? centre : 0.0);
    return setup_.normal.dot(x - water) + setup_.height;
  }
  const ReferenceState& state() {
    state_.dimension = D;
    auto water = mixture_water(spacing, D);
    water.smoothing_length = smoothing_length;
    water.viscosity = 0.0;
    water.volume = std::pow(spacing, D);
    auto rigid = mixture_rigid(spacing);
    rigid.smoothing_length = smoothing_length;
    rigid.volume = water.volume;
    state_.media = {water, rigid};
    ReferenceParticle particle;
    particle.position = Vector3::Constant(centre);
    if (D == 2) particle.position[2] = 0.0;
    particle.velocity = setup_.velocity;
    particle.compression = 0.01;
    state_.particles = {particle};
    const int side = 11, count = D == 3 ? side * side * side : side * side;
    for (int n = 0; n < count; ++n) {
      const Vector3 node(n % side - 5, n / side % side - 5, D == 3 ? n / (side * side) - 5 : 0);
      ReferenceParticle wall;
      wall.source = 1;
      wall.position = particle.position + spacing * node + setup_.shift;
      if (D == 2) wall.position[2] = 0.0;
      if (height_of(wall.position) <= 0.0) state_.particles.push_back(wall);
    }
    return state_;
  }

  WaterAtWall setup_;
  ReferenceState state_;
  Loaded<D, P, ContactPairs> loaded_;
  std::size_t water_ = 0;
};

// Sums over layers of the wall of the integral of `value` (distance from the particle, distance of
// the layer) over a layer, by the trapezoidal rule.
template <int D, class Value>
double layer_sum(double height, const Value& value) {
  double sum = 0.0;
  const double fine = 1e-3 * smoothing_length;
  for (int l = 0; l < 4; ++l) {
    const double x = height + (l + 0.5) * spacing;
    for (double t = 0.5 * fine; t < 2.0 * smoothing_length; t += fine)
      sum += spacing * fine * (D == 2 ? 2.0 : 2.0 * M_PI * t) * value(std::hypot(x, t), x);
  }
  return sum;
}

// The relative errors of sums over the wall, against those over layers, in the mean of all set-ups:
// of the sums with their factors 1 + `excess`, and of the bare ones over the lattice.
struct MeanErrors {
  double with_factor = 0.0, bare = 0.0;
  int count = 0;
  void add(double sum, double excess, double layers) {
    with_factor += std::abs(sum / layers - 1.0);
    bare += std::abs(sum / (1.0 + excess) / layers - 1.0);
    ++count;
  }
  // Factors are limited to 0.6 to 1.5 and fade where only a few faces look at the particle
  // (docs/theory/riemann_sph.md), so that a part of the error is left.
  void expect_cured() const {
    EXPECT_GT(bare / count, 0.03);
    EXPECT_LT(with_factor, 0.2 * bare);
  }
};

template <class Kind>
class RigidWallForces : public testing::Test {};
TYPED_TEST_SUITE(RigidWallForces, OtherTwoKinds);

template <int D>
WaterAtWall random_wall(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  WaterAtWall setup;
  setup.normal = Vector3(uniform(engine), uniform(engine), D == 3 ? uniform(engine) : 0.0);
  setup.normal.normalize();
  setup.shift = 0.5 * spacing * Vector3(uniform(engine), uniform(engine), uniform(engine));
  setup.height = spacing * (0.6 + 0.3 * uniform(engine));  // of the first row of water
  return setup;
}

// The wall is as large as the support.
TYPED_TEST(RigidWallForces, AreThoseOfLayersAlongTheSurface) {
  constexpr int D = TypeParam::D;
  std::mt19937 engine(4);
  MeanErrors force, kernel_sum;
  for (int n = 0; n < 40; ++n) {
    const WaterAtWall setup = random_wall<D>(engine);
    const Evaluated<D, typename TypeParam::P> water(setup);
    const double slope = layer_sum<D>(setup.height, [](double r, double x) {
      return x * WendlandC2<D>::slope_per_distance(r, smoothing_length);
    });
    const double kernel = layer_sum<D>(
        setup.height, [](double r, double) { return WendlandC2<D>::value(r, smoothing_length); });
    const double own = std::pow(spacing, D) * WendlandC2<D>::value(0.0, smoothing_length);
    const double expected = 2.0 * water.volume() * water.pressure() * slope;
    const double along = water.force().dot(setup.normal);
    force.add(along, water.force_excess(), expected);
    EXPECT_LE((water.force() - along * setup.normal).norm(), 5e-3 * expected) << n;
    kernel_sum.add(water.kernel_sum() - own, water.volume_excess(), kernel);
  }
  force.expect_cured();
  kernel_sum.expect_cured();
}

// Water that slides along the wall is neither compressed nor braked; with its speed towards the
// wall it is compressed at the rate 2 U sum_l d w_2.
TYPED_TEST(RigidWallForces, SlidingIsFree) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  const double rounding = std::is_same_v<P, Double> ? 1e-10 : 1e-4;
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  MeanErrors compression;
  for (int n = 0; n < 20; ++n) {
    WaterAtWall setup = random_wall<D>(engine);
    const Evaluated<D, P> at_rest(setup);
    Vector3 along(uniform(engine), uniform(engine), D == 3 ? uniform(engine) : 0.0);
    setup.velocity = 5.0 * (along - along.dot(setup.normal) * setup.normal);
    const Evaluated<D, P> sliding(setup);
    const double slope = layer_sum<D>(setup.height, [](double r, double x) {
      return x * WendlandC2<D>::slope_per_distance(r, smoothing_length);
    });
    EXPECT_LE(std::abs(sliding.compression_rate()), rounding * 5.0 * slope) << n;
    EXPECT_LE((sliding.force() - at_rest.force()).norm(), rounding * at_rest.force().norm()) << n;
    setup.velocity = -2.0 * setup.normal;
    const double expected = 1.01 * 2.0 * 2.0 * slope;
    const Evaluated<D, P> coming(setup);
    compression.add(coming.compression_rate(), coming.force_excess(), expected);
  }
  compression.expect_cured();
}

}  // namespace
}  // namespace kerf::test::smooth_wall_test
