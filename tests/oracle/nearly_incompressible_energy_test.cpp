// SPDX-License-Identifier: Apache-2.0
// A free solid whose bulk modulus acts in part by the density keeps its energy without any
// viscosity, at the default time step: its kinetic energy never exceeds that which it began with.
#include <algorithm>
#include <cmath>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

// A block of 20 x 10 x 6 spacings that is stretched along x and shaken.
Case shaken_block(int dimension, double poisson) {
  Case c = empty_case(dimension, PrecisionKind::mixed);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  Material& solid = c.materials[0];
  solid.poisson_ratio = poisson;
  solid.failure_strain = 0.0;
  solid.artificial_linear = solid.artificial_quadratic = 0.0;
  c.bodies = {
      body("block", Role::elastic, box({-0.01, -0.005, -0.003}, {0.01, 0.005, 0.003}), 1e-3)};
  c.bodies[0].velocity = {"0.01*x/0.01 + 0.002*sin(3000*x)", "0", "0"};
  return c;
}

// Returns the greatest kinetic energy in so many steps, over that of the start.
double greatest_growth(const Case& description, int steps) {
  const auto simulation = make_simulation(description);
  const double begun = simulation->balance().kinetic;
  double most = 0.0;
  for (int step = 0; step < steps; ++step) {
    simulation->advance();
    if (step % 20 == 0) most = std::max(most, simulation->balance().kinetic);
  }
  EXPECT_LE(std::abs(simulation->balance().energy_drift()), 0.01);
  return most / begun;
}

// Waves grow by some 2% per step where a density follows velocities that were extrapolated by the
// bonds of the step before, and by 0.1% just above the Poisson's ratio up to which bonds carry all
// of K.
TEST(NearlyIncompressibleEnergy, IsKeptWithoutViscosityInAPlane) {
  for (const double poisson : {0.415, 0.43, 0.45, 0.47, 0.49})
    EXPECT_LE(greatest_growth(shaken_block(2, poisson), 3000), 1.001) << poisson;
}

TEST(NearlyIncompressibleEnergy, IsKeptWithoutViscosityInSpace) {
  for (const double poisson : {0.43, 0.45})
    EXPECT_LE(greatest_growth(shaken_block(3, poisson), 1000), 1.001) << poisson;
}

}  // namespace
}  // namespace kerf::test
