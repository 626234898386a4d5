// SPDX-License-Identifier: Apache-2.0
// Bars of nearly incompressible solids under traction against Hooke's law in plane strain.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "analysis/line_slope.hpp"
#include "materials/elastic_moduli.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test::nearly_incompressible_bar_test {
namespace {

constexpr double length = 0.05, half_width = 0.005, young = 1e5;  // m, m, Pa

Shape turned(double angle, const Point& from, const Point& to) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  for (const auto& [x, y] :
       {std::pair{from[0], from[1]}, {to[0], from[1]}, {to[0], to[1]}, {from[0], to[1]}})
    shape.vertices.push_back(
        {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)});
  return shape;
}

// A bar with so many rows of particles, joined to a clamp, whose end bears a pressure, Pa.
Case bar(double angle, int rows, double poisson_ratio, double pressure) {
  Case c = empty_case(2, PrecisionKind::mixed);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  Material& rubber = c.materials[0];
  rubber.youngs_modulus = young;
  rubber.poisson_ratio = poisson_ratio;
  rubber.failure_strain = 0.0;
  rubber.artificial_linear = rubber.artificial_quadratic = 0.0;
  const double spacing = 2.0 * half_width / rows;
  c.bodies = {
      body("bar", Role::elastic, turned(angle, {0.0, -half_width}, {length, half_width}), spacing),
      body("clamp", Role::elastic, turned(angle, {-6.0 * spacing, -half_width}, {0.0, half_width}),
           spacing)};
  c.bodies[1].fixed = true;
  c.bodies[1].joined_to = "bar";
  Load load;
  load.kind = LoadKind::pressure;
  load.body = "bar";
  load.region = turned(angle, {length - 1e-4, -0.02}, {length + 1e-3, 0.02});
  load.pressure = pressure;
  c.loads = {load};
  c.time.end = c.time.relax = 0.06;
  return c;
}

// Strains along and across the bar in its middle, by a fit.
struct Strains {
  double along, across;
};
// A particle of the bar: where it was laid out and how far it has moved, along the bar and across.
struct Moved {
  double along, across, stretch, growth;
};
Strains strains_of(const Case& c, double angle) {
  const auto simulation = make_simulation(c);
  const Frame before = simulation->frame();
  while (!simulation->finished()) simulation->advance();
  const Frame after = simulation->frame();
  EXPECT_LT(std::abs(simulation->balance().energy_drift()), 1e-3);
  const auto turn = [&](const auto& p) {
    return std::pair{p[0] * std::cos(angle) + p[1] * std::sin(angle),
                     p[1] * std::cos(angle) - p[0] * std::sin(angle)};
  };
  std::map<std::uint32_t, std::size_t> row;
  for (std::size_t k = 0; k < after.id.size(); ++k) row[after.id[k]] = k;
  std::vector<Moved> middle;
  for (std::size_t i = 0; i < before.id.size(); ++i) {
    const auto [s, q] = turn(before.position[i]);
    const auto [s_now, q_now] = turn(after.position[row.at(before.id[i])]);
    if (s >= 0.015 && s <= 0.04) middle.push_back({s, q, s_now - s, q_now - q});
  }
  return {
      line_slope(
          middle, [](const Moved& p) { return p.along; }, [](const Moved& p) { return p.stretch; }),
      line_slope(
          middle, [](const Moved& p) { return p.across; },
          [](const Moved& p) { return p.growth; })};
}

// In plane strain a bar stretches by sigma (1 - nu^2) / E and contracts by sigma nu (1 + nu) / E,
// whether it is pulled or pressed. In the two rows at a face the pressure sums lack neighbours,
// which makes the bar stiffer by an amount that halves with the spacing.
TEST(NearlyIncompressible, BarObeysHookePulledAndPressed) {
  struct Trial {
    int rows;
    double angle, pressure, tolerance;
  };
  for (const auto& [rows, angle, pressure, tolerance] :
       {Trial{10, 0.0, -100.0, 0.065}, Trial{10, 0.4, -100.0, 0.04}, Trial{10, 0.4, 100.0, 0.04},
        Trial{20, 0.4, -100.0, 0.02}}) {
    const double nu = 0.49, strain = -pressure / young;
    const Strains found = strains_of(bar(angle, rows, nu, pressure), angle);
    const double along = strain * (1.0 - nu * nu), across = -strain * nu * (1.0 + nu);
    std::printf("%d rows, %g Pa, angle %g: along %.4f, across %.4f of theory\n", rows, pressure,
                angle, found.along / along, found.across / across);
    EXPECT_NEAR(found.along / along, 1.0, tolerance);
    EXPECT_NEAR(found.across / across, 1.0, 0.035);
  }
}

// Beyond K = 50 G a pulled solid bears as at that ratio.
TEST(NearlyIncompressible, TensileExcessIsThatOfFiftyTimesTheShearModulus) {
  EXPECT_DOUBLE_EQ(tensile_excess_modulus(3.0, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(tensile_excess_modulus(20.0, 1.0), 15.0);
  EXPECT_DOUBLE_EQ(tensile_excess_modulus(5000.0, 1.0), 45.0);
}

}  // namespace
}  // namespace kerf::test::nearly_incompressible_bar_test
