// SPDX-License-Identifier: Apache-2.0
// The work of rigid bodies that move, in the balance of energy, against force times displacement
// and against the same run in a frame in which the body rests.
#include <cmath>
#include <string>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

struct Pushed {
  const char* name;
  int dimension;
  Formulation formulation;
  Role role;         // of what is pushed
  bool is_mirrored;  // at a plane through it
};

// A plate, whose path is given, pushes a block of elastic solid or water before it, and drags it
// aside.
Case plate_and_block(const Pushed& of) {
  Case c = empty_case(of.dimension, PrecisionKind::double_precision);
  c.formulation = of.formulation;
  c.smoothing_ratio = of.formulation == Formulation::standard ? 1.3 : 1.5;
  const double z = of.dimension == 3 ? 3e-3 : 0.0;
  c.bodies = {body("plate", Role::rigid, box({-3e-3, -5e-3, -2.0 * z}, {0.0, 5e-3, 2.0 * z}), 1e-3),
              body("block", of.role, box({0.0, -3e-3, -z}, {4e-3, 3e-3, z}), 1e-3)};
  c.bodies[0].friction = 0.4;
  c.bodies[0].repelling_layer = RepellingLayer::all;
  c.materials[0].failure_strain = 0.0;
  c.materials[0].friction = 0.4;
  c.materials[1].viscosity = 0.5;
  if (of.is_mirrored) {
    c.symmetry.minimum[1] = true;
    c.domain.minimum[1] = 0.0;
  }
  return c;
}

// Two plates that squeeze a block between them, or two clamps that pull at it, balance one another:
// what remains of the momentum is rounding, relative to their impulses by magnitude, which each
// has.
TEST(BalancedConstraints, LeaveRoundingOfMomentum) {
  for (const Role role : {Role::rigid, Role::elastic}) {
    Case c = empty_case(2, PrecisionKind::double_precision);
    c.formulation = Formulation::standard;
    c.smoothing_ratio = 1.3;
    c.materials[0].failure_strain = 0.0;
    c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.0;
    c.bodies = {body("left", role, box({-3e-3, -3e-3, 0.0}, {0.0, 3e-3, 0.0}), 1e-3),
                body("right", role, box({8e-3, -3e-3, 0.0}, {11e-3, 3e-3, 0.0}), 1e-3),
                body("block", Role::elastic, box({0.0, -3e-3, 0.0}, {8e-3, 3e-3, 0.0}), 1e-3)};
    if (role == Role::elastic) c.bodies[0].joined_to = c.bodies[1].joined_to = "block";
    c.bodies[0].displacement = {"1e-4*min(t/0.01, 1)", "0", "0"};
    c.bodies[1].displacement = {"-1e-4*min(t/0.01, 1)", "0", "0"};
    c.time.relax = c.time.end = 0.02;
    const auto simulation = make_simulation(c);
    while (!simulation->finished()) simulation->advance();
    const Balance now = simulation->balance();
    // E' times the strain, the mean of which is half of the last one while the plates move.
    const double stress = 1e5 / (1.0 - 0.09) * 2e-4 / 8e-3;
    EXPECT_NEAR(now.constraint_scale, 2.0 * stress * 6e-3 * 0.015, 0.2 * now.constraint_scale);
    EXPECT_LT(now.momentum_error(), 1e-11);
  }
}

class MovingWalls : public testing::TestWithParam<Pushed> {};

// The work is the force times the displacement of the plate, step by step.
TEST_P(MovingWalls, WorkByForceTimesDisplacement) {
  Case c = plate_and_block(GetParam());
  const bool slides = !GetParam().is_mirrored;
  c.bodies[0].displacement = {"0.2*t + 60*t^2", slides ? "0.1*t - 20*t^2" : "0", "0"};
  const auto path = [slides](double t) -> Point {
    return {0.2 * t + 60.0 * t * t, slides ? 0.1 * t - 20.0 * t * t : 0.0, 0.0};
  };
  const auto simulation = make_simulation(c);
  double work = 0.0;
  Balance before = simulation->balance();
  Point from = path(0.0);
  for (int n = 0; n < 300; ++n) {
    simulation->advance();
    const Balance now = simulation->balance();
    const Point to = path(simulation->time());
    for (std::size_t a = 0; a < 3; ++a)
      work -= (to[a] - from[a]) * (before.impulse_rigid[a] - now.impulse_rigid[a]) /
              simulation->last_step().dt;
    before = now;
    from = to;
  }
  ASSERT_NE(before.work_constraint, 0.0);
  EXPECT_NEAR(before.work_constraint, work, 1e-9 * std::abs(work));
  if (GetParam().role == Role::elastic) {
    EXPECT_EQ(before.dissipated_density, 0.0);
  }
  if (GetParam().formulation == Formulation::standard) {
    const double drift = GetParam().role == Role::water ? 1e-9 : 0.03;
    EXPECT_LE(std::abs(before.energy_drift()), drift);
  }
}

// What the body takes up and dissipates does not depend on whether the plate moves or the block.
TEST_P(MovingWalls, LossesAreThoseWithThePlateAtRest) {
  Case moving = plate_and_block(GetParam());
  moving.time.maximum_step = 4e-6;  // the limits of the step depend on the speeds in the frame
  Case resting = moving;
  const bool slides = !GetParam().is_mirrored;
  moving.bodies[0].displacement = {"0.5*t", slides ? "-0.3*t" : "0", "0"};
  resting.bodies[1].velocity = {"-0.5", slides ? "0.3" : "0", "0"};
  const auto of_moving = make_simulation(moving), of_resting = make_simulation(resting);
  take_steps(*of_moving, 300);
  take_steps(*of_resting, 300);
  const Balance a = of_moving->balance(), b = of_resting->balance();
  ASSERT_NEAR(of_moving->time(), of_resting->time(), 1e-9 * of_resting->time());
  const double scale = 1e-7 * b.energy_initial;
  EXPECT_NEAR(a.impulse_rigid[0], b.impulse_rigid[0], 1e-7 * b.impulse_rigid[0]);
  EXPECT_NEAR(a.dissipated_artificial, b.dissipated_artificial, scale);
  EXPECT_NEAR(a.dissipated_density, b.dissipated_density, scale);
  EXPECT_NEAR(a.pressure_work, b.pressure_work, scale);
  EXPECT_NEAR(a.elastic_strain, b.elastic_strain, scale);
  EXPECT_NEAR(a.rigid_potential, b.rigid_potential, scale);
}

constexpr auto standard = Formulation::standard, paper = Formulation::shinohara2004;
INSTANTIATE_TEST_SUITE_P(AllPairs, MovingWalls,
                         testing::Values(Pushed{"Solid2D", 2, standard, Role::elastic, false},
                                         Pushed{"Solid3D", 3, standard, Role::elastic, false},
                                         Pushed{"Water2D", 2, standard, Role::water, false},
                                         Pushed{"Water3D", 3, standard, Role::water, false},
                                         Pushed{"WaterAtAPlane", 2, standard, Role::water, true},
                                         Pushed{"SolidAtAPlane", 2, standard, Role::elastic, true},
                                         Pushed{"SolidOfThePaper", 2, paper, Role::elastic, false},
                                         Pushed{"WaterOfThePaper", 3, paper, Role::water, false}),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace kerf::test
