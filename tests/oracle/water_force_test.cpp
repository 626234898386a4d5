// SPDX-License-Identifier: Apache-2.0
// The force of the water on solids against the momentum that they take, and against theory.
#include <cmath>
#include <cstdio>

#include "simulation/balance.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

// A free block in a domain that no particle leaves.
Case free_block(int dimension, Formulation formulation, PrecisionKind precision) {
  Case c = jet_on_block(dimension, precision, formulation);
  c.gravity = {};
  c.bodies.pop_back();  // the plate
  c.domain = {{-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}};
  return c;
}

// The momentum gain of a free block is the impulse of the water.
void expect_impulse(int dimension, Formulation formulation, PrecisionKind precision) {
  const auto simulation = make_simulation(free_block(dimension, formulation, precision));
  take_steps(*simulation, dimension == 2 ? 800 : 250);
  const Frame frame = simulation->frame();
  std::array<double, 3> momentum{};
  for (std::size_t k = 0; k < frame.id.size(); ++k)
    for (std::size_t a = 0; a < 3; ++a)
      if (frame.category[k] != Category::water)
        momentum[a] += double(frame.mass[k]) * frame.velocity[k][a];
  const Balance balance = simulation->balance();
  const double struck = std::abs(momentum[1]);
  ASSERT_GT(struck, 0.01 * std::abs(balance.momentum_in[1]));
  const double digits = precision == PrecisionKind::mixed
                            ? 1e-4
                            : 1e-6;  // the masses of a frame are in single precision
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_NEAR(balance.impulse_water[a], momentum[a], digits * struck) << "xyz"[a];
}

TEST(WaterForce, EqualsTheMomentumGainOfAFreeBlock) {
  for (const Formulation formulation : {Formulation::standard, Formulation::shinohara2004})
    for (const int dimension : {2, 3})
      for (const PrecisionKind precision : {PrecisionKind::mixed, PrecisionKind::double_precision})
        expect_impulse(dimension, formulation, precision);
}

// A jet that is deflected along the face of a broad block loses all of its momentum: F = rho w V^2
// (for instance Batchelor, An Introduction to Fluid Dynamics, 1967, section 6.3).
TEST(WaterForce, OfAJetEqualsItsMomentumFlux) {
  Case c = jet_on_block(2, PrecisionKind::mixed, Formulation::standard);
  c.gravity = {};
  c.bodies.pop_back();
  const double width = 5e-3;
  c.bodies[0] = body("block", Role::elastic, box({-0.025, 0.0, 0.0}, {0.025, 0.003, 0.0}), 5e-4);
  c.bodies[0].fixed = true;
  c.materials[0].failure_strain = 0.0;
  c.jets = {jet(width, 5e-4, {0.0, 0.003, 0.0}, 10e-3)};
  c.domain = {{-0.03, -0.01, 0.0}, {0.03, 0.03, 0.0}};
  const auto simulation = make_simulation(c);
  const auto advance_to = [&](double time) {
    while (simulation->time() < time) simulation->advance();
    return std::pair{simulation->time(), simulation->balance().impulse_water};
  };
  const auto [begin, at_begin] = advance_to(0.020);
  const auto [end, at_end] = advance_to(0.032);
  const double force = (at_end[1] - at_begin[1]) / (end - begin);
  const double theory = -1000.0 * width * 5.0 * 5.0;
  std::printf("force %.2f N/m, theory %.2f N/m\n", force, theory);
  EXPECT_NEAR(force / theory, 1.0, 0.03);
  EXPECT_NEAR((at_end[0] - at_begin[0]) / (end - begin) / theory, 0.0, 0.01);
  EXPECT_NE(simulation->balance().force_water[1], 0.0);
}

}  // namespace
}  // namespace kerf::test
