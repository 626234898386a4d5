// SPDX-License-Identifier: Apache-2.0
// Nearly incompressible solids with jumps of the spacing, and the search for their neighbours.
#include <array>
#include <cmath>
#include <cstdio>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

// A laterally confined column of gel hits a floor with V and comes to rest behind a wave, under rho
// c_p V; see nearly_incompressible_test.cpp. It is fine below y = 15 mm and coarse above.
Case column(bool graded) {
  Case c = empty_case(2, PrecisionKind::mixed);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.bodies = {body("floor", Role::rigid, box({-0.014, -0.004, 0.0}, {0.014, 0.0, 0.0}), 1e-3),
              body("left", Role::rigid, box({-0.014, 0.0, 0.0}, {-0.01, 0.06, 0.0}), 1e-3),
              body("right", Role::rigid, box({0.01, 0.0, 0.0}, {0.014, 0.06, 0.0}), 1e-3),
              body("gel", Role::elastic, box({-0.01, 0.0, 0.0}, {0.01, 0.048, 0.0}), 1e-3)};
  c.materials[0].poisson_ratio = 0.49;
  c.materials[0].failure_strain = 0.0;
  c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.1;
  c.bodies[3].velocity = {"0", "-0.05", "0"};
  if (!graded) return c;
  c.bodies[3].grading = {1, 8e-3, box({-0.02, -0.02, 0.0}, {0.02, 6e-3, 0.0}), {}};
  for (Body& part : c.bodies) part.spacing = 0.5e-3;
  return c;
}

struct Pressed {
  double mean = 0.0;     // Pa
  double scatter = 0.0;  // Pa, root of the mean square
};
// Returns - sigma_yy of the gel between two heights, away from the walls.
Pressed pressure_between(const Frame& frame, double low, double high) {
  const Column* shear = nullptr;
  for (const Column& column : frame.columns)
    if (column.name == "deviatoric_stress") shear = &column;
  double sum = 0.0, square = 0.0, count = 0.0;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    const auto& x = frame.position[i];
    if (frame.category[i] != Category::solid || std::abs(x[0]) > 0.005 || x[1] < low || x[1] > high)
      continue;
    const double value = frame.pressure[i] - shear->values[6 * i + 1];
    sum += value, square += value * value, count += 1.0;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, square / count - mean * mean))};
}

// The graded column has the spacing of the uniform one in its coarse part, and half of it below.
// The stress in a column of one spacing is 3 to 6% below rho c V while its layers fill the gap at
// the walls; the error and the scatter of the graded one must not be larger.
TEST(Graded, PressureIsContinuousAtAJump) {
  const double k = 1e5 / (3.0 * (1.0 - 2.0 * 0.49)), g = 1e5 / (2.0 * 1.49);
  const double wave = std::sqrt((k + 4.0 / 3.0 * g) / 940.0), due = 940.0 * wave * 0.05;
  constexpr double heights[3][2] = {{5e-3, 10e-3}, {10e-3, 20e-3}, {20e-3, 25e-3}};
  Pressed at[2][3];
  for (const bool graded : {false, true}) {
    const auto simulation = make_simulation(column(graded));
    while (simulation->time() < 0.9 * 0.048 / wave) simulation->advance();
    const Frame frame = simulation->frame();
    for (int n = 0; n < 3; ++n) {
      at[graded][n] = pressure_between(frame, heights[n][0], heights[n][1]);
      std::printf("%s, %g to %g mm: %.4f of rho c V, scatter %.4f\n", graded ? "graded" : "uniform",
                  1e3 * heights[n][0], 1e3 * heights[n][1], at[graded][n].mean / due,
                  at[graded][n].scatter / due);
    }
    EXPECT_LT(std::abs(simulation->balance().energy_drift()), 1e-3);
    for (const std::uint16_t source : frame.source)
      EXPECT_LT(source, 4);  // a body has one source in frames
  }
  for (int n = 0; n < 3; ++n) {
    const double off = std::abs(at[0][n].mean - due);
    EXPECT_NEAR(at[1][n].mean, due, off + 0.01 * due);
    EXPECT_LT(at[1][n].scatter, at[0][n].scatter + 0.01 * due);
  }
}

// The list has as many neighbours, by a grid for each level, as a brute-force search finds.
TEST(Graded, NeighboursOfEveryLevelAreFound) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].poisson_ratio = 0.49;
  c.bodies = {body("gel", Role::elastic, box({-0.032, 0.0, 0.0}, {0.032, 0.032, 0.0}), 1e-3)};
  c.bodies[0].grading = {2, 8e-3, box({-2e-3, 0.02, 0.0}, {2e-3, 0.04, 0.0}), {}};
  const auto simulation = make_simulation(c);
  const Frame frame = simulation->frame();
  std::array<int, 3> levels{};
  double pairs = 0.0;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    ++levels[static_cast<std::size_t>(std::lround(std::log2(double(frame.spacing[i]) / 1e-3)))];
    for (std::size_t j = 0; j < frame.id.size(); ++j) {
      const double reach = 1.3 * (double(frame.spacing[i]) + double(frame.spacing[j])) + 0.35e-3;
      const auto &x = frame.position[i], &y = frame.position[j];
      pairs += i != j && std::hypot(x[0] - y[0], x[1] - y[1]) < reach ? 1.0 : 0.0;
    }
  }
  for (const int count : levels) EXPECT_GT(count, 0);
  EXPECT_DOUBLE_EQ(simulation->neighbours_per_particle() * double(frame.id.size()), pairs);
}

}  // namespace
}  // namespace kerf::test
