// SPDX-License-Identifier: Apache-2.0
// Runs with subcycling: steps of the water within steps of the solids (time/subcycling.hpp).
#include <cmath>

#include "engine/device.hpp"
#include "support/farthest.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

constexpr int subcycles = 4;

// A vibrating block of tofu, alone or with distant water at rest, whose waves require shorter
// steps.
Case vibrating(int dimension, bool with_water) {
  Case c = empty_case(dimension, PrecisionKind::double_precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = 0.0;  // does not break
  c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.0;
  c.materials[1].sound_speed = 100.0;
  c.numerics.subcycles = subcycles;
  const double z = dimension == 3 ? 3e-3 : 0.0;
  c.bodies = {body("block", Role::elastic, box({-3e-3, -3e-3, -z}, {3e-3, 3e-3, z}), 1e-3)};
  c.bodies[0].velocity = {"0.3*sin(700*y)", "0.2*sin(400*x)", "0"};
  if (with_water)
    c.bodies.push_back(body("water", Role::water, box({0.05, 0.05, -z}, {0.053, 0.053, z}), 1e-3));
  return c;
}

// With constant forces within the step of the solid its position and velocity at the end of it
// equal those of position Verlet with that step, up to rounding.
class SubcyclingRuns : public testing::TestWithParam<int> {};

TEST_P(SubcyclingRuns, AnUncoupledSolidMovesAsByVerlet) {
  const Case with_water = vibrating(GetParam(), true);
  const auto apart = make_simulation(with_water);
  take_steps(*apart, 1);  // after which the wave speed of the solid is known
  const double dt = apart->last_step().dt;
  take_steps(*apart, 40 * subcycles);
  EXPECT_EQ(apart->last_step().limit, "acoustic (water)");
  EXPECT_NEAR(apart->time(), (1 + 40 * subcycles) * dt, 1e-9 * apart->time());

  Case alone = vibrating(GetParam(), false);
  alone.time.maximum_step = dt;
  const auto verlet = make_simulation(alone);
  take_steps(*verlet, 1);
  alone.time.maximum_step = subcycles * dt;
  const auto longer = make_simulation(alone);
  longer->restore(saved(*verlet));
  take_steps(*longer, 40);
  EXPECT_NEAR(longer->last_step().dt, subcycles * dt, 1e-12 * dt);
  EXPECT_NEAR(longer->time(), apart->time(), 1e-9 * apart->time());

  const auto place = [](const Frame& frame) -> auto& {
    return frame.position;
  };
  const Frame now = longer->frame();
  const double distance = farthest(now, apart->frame(), place);
  const double moved = farthest(now, make_simulation(alone)->frame(), place);
  EXPECT_GT(moved, 0.05e-3);
  EXPECT_LT(distance, 1e-9 * moved);
}

// The load of a jet on a free block of gel is about the same, and the impulses of both are equal
// and opposite.
TEST_P(SubcyclingRuns, AJetLoadsABlockAsWithACommonStep) {
  Case c = standard_jet_on_block(GetParam(), PrecisionKind::double_precision);
  c.materials[0].failure_strain = 0.0;
  c.materials[1].sound_speed = 100.0;
  c.gravity = {0.0, 0.0, 0.0};
  c.bodies.pop_back();  // the plate
  c.numerics.subcycles = 1;
  const auto together = make_simulation(c);
  c.numerics.subcycles = 8;
  const auto apart = make_simulation(c);
  const double end = 2e-3;
  while (together->time() < end) together->advance();
  while (apart->time() < end) apart->advance();
  EXPECT_LT(apart->pair_interactions(), together->pair_interactions());
  const Balance a = apart->balance(), b = together->balance();
  EXPECT_LE(a.momentum_error(), 1e-10);
  EXPECT_LE(std::abs(a.energy_drift()), 2e-3);
  EXPECT_GT(std::abs(b.impulse_water[1]), 0.0);
  EXPECT_NEAR(a.impulse_water[1], b.impulse_water[1], 0.01 * std::abs(b.impulse_water[1]));
  EXPECT_NEAR(a.elastic_strain, b.elastic_strain, 0.03 * b.elastic_strain);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, SubcyclingRuns, testing::Values(2, 3));

}  // namespace
}  // namespace kerf::test
