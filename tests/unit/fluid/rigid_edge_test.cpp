// SPDX-License-Identifier: Apache-2.0
// On water that passes the end of a rigid face the wall acts along the line from the edge, the
// nearest point of the wall, so that the water turns around it freely.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fluid/smooth_wall.hpp"
#include "support/standard_mixture.hpp"
#include "time/verlet.hpp"

namespace kerf::test::rigid_edge_test {
namespace {

constexpr double spacing = 1e-3, smoothing_length = 1.3 * spacing, centre = 0.01;

// A wall that fills a quadrant, whose bisector has the angle `turn` to the x axis, and a particle
// of water in the opposite quadrant.
struct WaterAtEdge {
  double turn = 0.0;                           // rad
  double angle = 0.0, height = 0.5 * spacing;  // rad from the bisector, m: where the water is
  Vector3 velocity = Vector3::Zero();          // m/s

  Vector3 away() const { return {std::cos(turn + angle), std::sin(turn + angle), 0.0}; }
  // Along a circle about the edge.
  Vector3 around() const { return Vector3::UnitZ().cross(away()); }
};

class Evaluated {
 public:
  explicit Evaluated(const WaterAtEdge& setup)
      : setup_(setup), loaded_(state(), {0.0, 0.02, 5e-4}) {
    auto& particles = loaded_.particles;
    const auto place = loaded_.places();
    for (std::size_t k = 1; k < place.size(); ++k) {
      particles.face_normal[place[k]] = Vector<2, double>::from(normals_[k - 1]);
      particles.face_depth[place[k]] = depths_[k - 1];
    }
    evaluate_standard<2, Double>(state_, loaded_);
    for_each_index(particles.size(), UpdateSurfaceFlags<2, Double>{particles.view()});
    water_ = place[0];
    is_at_edge_ = (particles.flags[water_] & flag::at_edge) != 0;
    particles.flags[water_] = static_cast<std::uint8_t>(particles.flags[water_] & ~flag::surface);
    evaluate_standard<2, Double>(state_, loaded_);
  }
  Vector3 force() const { return state_.media[0].mass * as_eigen(acceleration()); }
  double compression_rate() const { return loaded_.particles.compression_rate[water_]; }
  bool is_at_edge() const { return is_at_edge_; }

 private:
  Vector<2, double> acceleration() const { return loaded_.particles.acceleration[water_]; }
  const ReferenceState& state() {
    state_.dimension = 2;
    auto water = mixture_water(spacing, 2);
    water.smoothing_length = smoothing_length;
    water.viscosity = 0.0;
    water.volume = spacing * spacing;
    auto rigid = mixture_rigid(spacing);
    rigid.smoothing_length = smoothing_length;
    rigid.volume = water.volume;
    state_.media = {water, rigid};
    const Vector3 edge(centre, centre, 0.0);
    ReferenceParticle particle;
    particle.position = edge + setup_.height * setup_.away();
    particle.velocity = setup_.velocity;
    particle.compression = 0.01;
    state_.particles = {particle};
    const double first = setup_.turn + M_PI / 4.0, second = setup_.turn - M_PI / 4.0;
    const Vector3 along_first(std::cos(first), std::sin(first), 0.0);
    const Vector3 along_second(std::cos(second), std::sin(second), 0.0);
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) {
        ReferenceParticle wall;
        wall.source = 1;
        const double below_first = (i + 0.5) * spacing, below_second = (j + 0.5) * spacing;
        wall.position = edge - below_first * along_first - below_second * along_second;
        state_.particles.push_back(wall);
        normals_.push_back(i <= j ? along_first : along_second);
        depths_.push_back(std::min(below_first, below_second));
      }
    }
    return state_;
  }

  WaterAtEdge setup_;
  ReferenceState state_;
  std::vector<Vector3> normals_;
  std::vector<double> depths_;
  Loaded<2, Double, ContactPairs> loaded_;
  std::size_t water_ = 0;
  bool is_at_edge_ = false;
};

class RigidEdge : public testing::Test {
 protected:
  WaterAtEdge random_setup() {
    WaterAtEdge setup;
    setup.turn = M_PI * uniform_(engine_);
    setup.angle = 0.15 * M_PI * uniform_(engine_);  // the edge is nearest up to pi / 4
    setup.height = spacing * (0.7 + 0.3 * uniform_(engine_));
    return setup;
  }
  std::mt19937 engine_{6};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

TEST_F(RigidEdge, PushesWaterAway) {
  for (int n = 0; n < 40; ++n) {
    WaterAtEdge setup = random_setup();
    setup.velocity = 1e-9 * setup.around();
    const Evaluated water(setup);
    EXPECT_TRUE(water.is_at_edge()) << n;
    const double away = water.force().dot(setup.away());
    EXPECT_GT(away, 0.0) << n;
    EXPECT_LE((water.force() - away * setup.away()).norm(), 1e-10 * away) << n;
  }
}

TEST_F(RigidEdge, TurningAroundItIsFree) {
  for (int n = 0; n < 40; ++n) {
    WaterAtEdge setup = random_setup();
    setup.velocity = 1e-9 * setup.around();
    const Evaluated slow(setup);
    setup.velocity = (n % 2 == 0 ? 5.0 : -5.0) * setup.around();
    const Evaluated turning(setup);
    EXPECT_LE(std::abs(turning.compression_rate()), 1e-9 * 5.0 / spacing) << n;
    EXPECT_LE((turning.force() - slow.force()).norm(), 1e-9 * slow.force().norm()) << n;
    EXPECT_TRUE(turning.is_at_edge()) << n;
    setup.velocity = -5.0 * setup.away();
    EXPECT_FALSE(Evaluated(setup).is_at_edge()) << n;
  }
}

}  // namespace
}  // namespace kerf::test::rigid_edge_test
