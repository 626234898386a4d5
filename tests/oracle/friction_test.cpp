// SPDX-License-Identifier: Apache-2.0
// A block slides on a plate of particles. By Coulomb's law its deceleration is friction x g;
// without friction the plate of particles does not decelerate it.
#include <cmath>
#include <string>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

struct Slide {
  double speed, lift;  // m/s and m after the run
  Balance balance;
};

Slide slide(int dimension, double friction, double speed, double seconds) {
  Case c = empty_case(dimension, PrecisionKind::mixed);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  const double z = dimension == 3 ? 4e-3 : 0.0;
  c.domain = {{-0.05, -0.05, -0.05}, {0.1, 0.05, 0.05}};
  c.gravity = {0.0, -10.0, 0.0};
  c.time.end = seconds;
  c.bodies = {
      body("block", Role::elastic, box({0.0, 0.0, -z}, {8e-3, 6e-3, z}), 1e-3),
      body("plate", Role::rigid, box({-5e-3, -3e-3, -2.0 * z}, {0.05, 0.0, 2.0 * z}), 1e-3)};
  c.bodies[0].velocity = {std::to_string(speed), "0", "0"};
  c.materials[0].failure_strain = 0.0;
  c.materials[0].friction = friction;
  const auto simulation = make_simulation(c);
  const Frame before = simulation->frame();
  while (!simulation->finished()) simulation->advance();
  const Frame frame = simulation->frame();
  Slide result{0.0, 0.0, simulation->balance()};
  double count = 0.0;
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    if (frame.category[k] == Category::rigid) continue;
    result.speed += frame.velocity[k][0];
    result.lift += frame.position[k][1];
    count += 1.0;
  }
  result.speed /= count;
  result.lift = result.lift / count - 3e-3;
  return result;
}

// At rest the overlap with the plate is less than a tenth of a spacing, and the block does not lift
// off. The remaining 1% is its oscillation under its weight.
TEST(Friction, SlowsDownBySlidingFriction) {
  for (int dimension : {2, 3}) {
    const Slide after = slide(dimension, 0.3, 0.5, 0.04);
    EXPECT_NEAR(after.speed, 0.5 - 0.3 * 10.0 * 0.04, 0.01 * 0.12 + 2e-4) << dimension;
    EXPECT_NEAR(after.lift, 0.0, 1e-4);
    EXPECT_GT(after.balance.dissipated_artificial, 0.0);
    EXPECT_LE(std::abs(after.balance.energy_drift()), 1e-3);
    EXPECT_LE(after.balance.momentum_error(), 1e-5);
  }
}

TEST(Friction, DoesNotActWithoutACoefficient) {
  for (int dimension : {2, 3})
    EXPECT_NEAR(slide(dimension, 0.0, 0.5, 0.04).speed, 0.5, 5e-4) << dimension;
}

// The speed of 0.2 m/s is 0 after 33 ms.
TEST(Friction, ComesToRest) {
  EXPECT_NEAR(slide(2, 0.6, 0.2, 0.04).speed, 0.0, 5e-3);
}

}  // namespace
}  // namespace kerf::test
