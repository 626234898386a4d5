// SPDX-License-Identifier: Apache-2.0
// Solids whose bulk modulus acts by the density, and debris, against closed forms.
#include <array>
#include <cmath>
#include <cstdio>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

// A trough 20 mm wide inside, with rigid walls of three layers or more.
Case trough(double height) {
  Case c = empty_case(2, PrecisionKind::mixed);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.bodies = {body("floor", Role::rigid, box({-0.014, -0.004, 0.0}, {0.014, 0.0, 0.0}), 1e-3),
              body("left", Role::rigid, box({-0.014, 0.0, 0.0}, {-0.01, height, 0.0}), 1e-3),
              body("right", Role::rigid, box({0.01, 0.0, 0.0}, {0.014, height, 0.0}), 1e-3)};
  return c;
}

// A laterally confined column of gel hits a floor with V: behind the wave that travels upwards with
// c_p^2 = (K + 4 G / 3) / rho it is at rest under rho c_p V, as in one-dimensional strain.
TEST(NearlyIncompressible, ColumnOnAFloor) {
  const double length = 0.04, speed = 0.05;
  Case c = trough(0.05);
  Material& gel = c.materials[0];
  gel.poisson_ratio = 0.49;
  gel.failure_strain = 0.0;
  gel.artificial_linear = gel.artificial_quadratic = 0.1;
  c.bodies.push_back(body("gel", Role::elastic, box({-0.01, 0.0, 0.0}, {0.01, length, 0.0}), 1e-3));
  c.bodies.back().velocity = {"0", "-0.05", "0"};
  const double k = 1e5 / (3.0 * (1.0 - 2.0 * 0.49)), g = 1e5 / (2.0 * 1.49);
  const double wave = std::sqrt((k + 4.0 / 3.0 * g) / 940.0);
  const auto simulation = make_simulation(c);
  while (simulation->time() < 0.8 * length / wave) simulation->advance();
  const Frame frame = simulation->frame();
  const Column* shear = nullptr;
  for (const Column& column : frame.columns)
    if (column.name == "deviatoric_stress") shear = &column;
  ASSERT_NE(shear, nullptr);
  double stress = 0.0, particles = 0.0, before = 0.0, ahead = 0.0;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    if (frame.category[i] != Category::solid || std::abs(frame.position[i][0]) > 0.005) continue;
    const double y = frame.position[i][1];
    if (y > 0.036) {  // ahead of the wave
      before += frame.velocity[i][1];
      ahead += 1.0;
    }
    if (y < 0.005 || y > 0.02) continue;
    stress += frame.pressure[i] - shear->values[6 * i + 1];
    particles += 1.0;
  }
  const double due = 940.0 * wave * speed;
  std::printf("gel on a floor: %.4g Pa, rho c V %.4g Pa, drift %.1e\n", stress / particles, due,
              simulation->balance().energy_drift());
  EXPECT_NEAR(stress / particles, due, 0.03 * due);
  EXPECT_NEAR(before / ahead, -speed, 0.1 * speed);
  EXPECT_LE(std::abs(simulation->balance().energy_drift()), 0.01);
}

// Adds the mean pressure over rho g H in each of ten layers of the content of the trough to `sum`.
void add_profile(const Frame& frame, double scale, std::array<double, 10>& sum) {
  std::array<double, 10> pressure{}, count{};
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    if (frame.category[i] != Category::fractured || frame.position[i][1] < 0.0) continue;
    const auto layer = static_cast<std::size_t>(frame.position[i][1] / 0.002);
    if (layer >= 10) continue;
    pressure[layer] += frame.pressure[i] / scale;
    count[layer] += 1.0;
  }
  for (std::size_t k = 0; k < 10; ++k) sum[k] += pressure[k] / std::max(1.0, count[k]);
}

// A solid that breaks at a very small strain, and is excited so that it does, rests in a trough as
// a liquid of its density: p = rho g h, and the floor carries the weight. Means are over five
// periods 4 H / c of the waves of its fall.
TEST(Debris, StandsAsALiquid) {
  const double depth = 0.02, gravity = 100.0, scale = 940.0 * gravity * depth;
  Case c = trough(0.03);
  c.gravity = {0.0, -gravity, 0.0};
  c.materials[0].failure_strain = 1e-5;
  c.bodies.push_back(
      body("crumbs", Role::elastic, box({-0.01, 0.0, 0.0}, {0.01, depth, 0.0}), 1e-3));
  c.bodies.back().velocity = {"0.02*sin(3000*x)", "0.02*sin(3000*y)", "0"};
  const auto simulation = make_simulation(c);
  while (simulation->time() < 0.02) simulation->advance();
  const double impulse = simulation->balance().impulse_rigid[1], from = simulation->time();
  const double period = 4.0 * depth / std::sqrt(1e5 / 1.2 / 940.0);
  std::array<double, 10> profile{};
  const int looks = 100;
  for (int n = 1; n <= looks; ++n) {
    while (simulation->time() < from + 5.0 * period * n / looks) simulation->advance();
    add_profile(simulation->frame(), scale, profile);
  }
  const Balance now = simulation->balance();
  const double force = (now.impulse_rigid[1] - impulse) / (simulation->time() - from);
  double square = 0.0;
  for (std::size_t k = 1; k < 9; ++k)  // rows at the floor and at the surface lack neighbours
    square += std::pow(profile[k] / looks - (0.95 - 0.1 * static_cast<double>(k)), 2) / 8.0;
  std::printf("loose solid: L2(p) %.3f of rho g H, floor %.4g N/m, weight %.4g N/m\n",
              std::sqrt(square), force, scale * 0.02);
  EXPECT_EQ(now.mass_fractured, now.mass_now);
  EXPECT_LE(std::sqrt(square), 0.03);
  EXPECT_NEAR(force, scale * 0.02, 0.02 * scale * 0.02);
}

}  // namespace
}  // namespace kerf::test
