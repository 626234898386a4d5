// SPDX-License-Identifier: Apache-2.0
// Dynamic relaxation: a column comes to rest under its weight.
#include <cmath>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test::relaxation_test {
namespace {

// A column of 30 mm on a clamped foot.
Case heavy_column(PrecisionKind precision) {
  Case c = empty_case(2, precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = 0.0;
  c.materials[0].poisson_ratio = 0.0;
  c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.0;
  c.bodies = {body("foot", Role::elastic, box({0.0, -0.004, 0.0}, {0.01, 0.0, 0.0}), 1e-3),
              body("column", Role::elastic, box({0.0, 0.0, 0.0}, {0.01, 0.03, 0.0}), 1e-3)};
  c.bodies[0].fixed = true;
  c.bodies[1].joined_to = "foot";
  c.gravity = {0.0, -9.81, 0.0};
  return c;
}

// The top sinks by rho g L^2 / 2 E; L is half a spacing more than the 30 of the column, since the
// held particles are centred half a spacing below its foot.
TEST(Relaxation, AColumnComesToRest) {
  for (const PrecisionKind precision : both_precisions) {
    Case c = heavy_column(precision);
    const double rho = 940.0, e = 1e5, length = 0.03, wave = std::sqrt(e / rho);
    c.time.relax = c.time.end = 15.0 * length / wave;
    const auto simulation = make_simulation(c);
    const Frame before = simulation->frame();
    while (!simulation->finished()) simulation->advance();
    const Balance now = simulation->balance();
    const Frame after = simulation->frame();
    const auto top = [](const Frame& frame) {
      double highest = 0.0;
      for (const auto& x : frame.position) highest = std::max(highest, x[1]);
      return highest;
    };
    const double held = length + 0.5e-3;
    const double due = rho * 9.81 * held * held / (2.0 * e);
    EXPECT_NEAR(top(before) - top(after), due, 0.02 * due);
    EXPECT_LT(now.damping_peak, 1e-3 * now.elastic_strain);
    EXPECT_GT(now.damping_peak, 0.0);
    // At rest the work of the weight is twice the stored energy; the other half was taken.
    EXPECT_NEAR(now.dissipated_damping, now.elastic_strain + now.hourglass,
                0.02 * now.elastic_strain);
    EXPECT_LT(std::abs(now.energy_drift()), 1e-3);
    EXPECT_LT(now.momentum_error(), precision == PrecisionKind::mixed ? 1e-5 : 1e-10);
  }
}

TEST(Relaxation, EndsAtItsTime) {
  Case c = heavy_column(PrecisionKind::mixed);
  c.time.relax = 1e-3;
  c.time.end = 0.01;
  const auto simulation = make_simulation(c);
  double at_end = -1.0;
  while (!simulation->finished()) {
    simulation->advance();
    if (at_end < 0.0 && simulation->time() > 1e-3)
      at_end = simulation->balance().dissipated_damping;
  }
  EXPECT_EQ(simulation->balance().dissipated_damping, at_end);
}

TEST(Relaxation, SameBitsAfterRestart) {
  Case c = heavy_column(PrecisionKind::mixed);
  c.time.relax = 1.0;
  EXPECT_GT(expect_same_bits_after_restart(c).dissipated_damping, 0.0);
}

}  // namespace
}  // namespace kerf::test::relaxation_test
