// SPDX-License-Identifier: Apache-2.0
// A free jet keeps the lattice of the nozzle at constant speed, with every particle once.
#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/nozzle.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

Case free_jet(int dimension, double stop) {
  Case c = empty_case(dimension, PrecisionKind::double_precision);
  c.jets = {jet(4.3e-3, 1e-3, {0.01, 0.0, 0.0}, 0.1)};
  c.jets[0].angle = 0.3;
  c.jets[0].azimuth = dimension == 3 ? 0.8 : 0.0;
  c.jets[0].start = 2e-4;
  c.jets[0].stop = stop;
  return c;
}

double along(const Nozzle& nozzle, const std::array<double, 3>& p) {
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a) sum += (p[a] - nozzle.exit()[a]) * nozzle.direction()[a];
  return sum;
}

void expect_free_flight(int dimension, Formulation formulation, double width = 4.3e-3,
                        const Numerics& numerics = {}) {
  Case c = free_jet(dimension, std::numeric_limits<double>::infinity());
  c.formulation = formulation;
  c.numerics = numerics;
  c.jets[0].width = width;
  const Nozzle nozzle(c.jets[0], 1000.0, dimension);
  const auto simulation = make_simulation(c);
  std::set<std::uint32_t> ever;
  while (simulation->time() < 3e-3) {
    simulation->advance();
    const Frame frame = simulation->frame();
    const std::set<std::uint32_t> now(frame.id.begin(), frame.id.end());
    ASSERT_EQ(now.size(), frame.id.size()) << "an id is there twice";
    ever.insert(now.begin(), now.end());
    ASSERT_EQ(ever.size(), frame.id.size()) << "a particle was added or removed";
  }
  const Frame frame = simulation->frame();
  const std::size_t layers = frame.id.size() / nozzle.columns();
  EXPECT_EQ(frame.id.size(), layers * nozzle.columns());
  // Four layers were in the nozzle at the start; V t / d more had entered at the start of the last
  // step.
  const double began = simulation->time() - simulation->last_step().dt;
  EXPECT_EQ(layers, 4 + static_cast<std::size_t>(5.0 * (began - 2e-4) / 1e-3));
  const double phase = along(nozzle, frame.position[0]);
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    const double steps = (along(nozzle, frame.position[k]) - phase) / 1e-3;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_NEAR(frame.velocity[k][a], 5.0 * nozzle.direction()[a], 1e-9);
    EXPECT_EQ(frame.upstream[k] != 0, along(nozzle, frame.position[k]) <= 0.0);
  }
  const Balance balance = simulation->balance();
  EXPECT_LE(balance.momentum_error(), 1e-12);
  EXPECT_LE(std::abs(balance.energy_drift()), 1e-9);
}
TEST(FreeJet, KeepsItsLattice2D) {
  expect_free_flight(2, Formulation::shinohara2004);
}
TEST(FreeJet, KeepsItsLattice3D) {
  expect_free_flight(3, Formulation::shinohara2004);
}
TEST(FreeJet, KeepsItsLatticeInTheStandardFormulation2D) {
  expect_free_flight(2, Formulation::standard);
}
TEST(FreeJet, KeepsItsLatticeInTheStandardFormulation3D) {
  expect_free_flight(3, Formulation::standard);
}

// The jet is wide enough to have interior particles.
TEST(FreeJet, IsNotShifted2D) {
  expect_free_flight(2, Formulation::standard, 10e-3, {WaterScheme::riemann, true});
}
TEST(FreeJet, IsNotShifted3D) {
  expect_free_flight(3, Formulation::standard, 9e-3, {WaterScheme::delta_sph, true});
}

// Columns of different speed drag at one another by their numerical shear, which is no pressure:
// the pump holds none of the water of a jet in the open back, in any direction.
TEST(FreeJet, WithAProfileIsNotHeldBack) {
  for (int dimension : {2, 3})
    for (const double angle : {0.0, 0.3}) {
      Case c = free_jet(dimension, std::numeric_limits<double>::infinity());
      c.formulation = Formulation::standard;
      c.smoothing_ratio = 1.3;
      c.jets[0].width = dimension == 2 ? 10e-3 : 8e-3;
      c.jets[0].profile = "1 - r^2";
      c.jets[0].angle = angle;
      c.materials[1].viscosity = 0.0;
      const auto simulation = make_simulation(c);
      while (simulation->time() < 6e-3) simulation->advance();
      const Balance balance = simulation->balance();
      EXPECT_LE(std::abs(balance.jet_mass_held_back), 5e-3 * balance.jet_mass_due) << angle;
    }
}

// A nozzle closes during the run: the water behind the exit stops; the mass is rho V A times the
// time that the nozzle was open, with the start and stop within steps.
TEST(FreeJet, StartsAndStopsWithinSteps) {
  for (int dimension : {2, 3}) {
    const Case c = free_jet(dimension, 1.5e-3);
    const Nozzle nozzle(c.jets[0], 1000.0, dimension);
    const auto simulation = make_simulation(c);
    while (simulation->time() < 3e-3) simulation->advance();
    const Balance balance = simulation->balance();
    const double area = dimension == 2 ? 4.3e-3 : std::acos(-1.0) * 4.3e-3 * 4.3e-3 / 4.0;
    const double due = 1000.0 * 5.0 * area * 1.3e-3;
    EXPECT_NEAR(balance.jet_mass_due, due, 1e-12 * due);
    EXPECT_NEAR(balance.mass_in + balance.jet_mass_carried, due, 1e-12 * due);
    EXPECT_LE(std::abs(balance.mass_error()), 1e-12);
    EXPECT_LE(balance.momentum_error(), 1e-12);
    const Frame frame = simulation->frame();
    EXPECT_GT(std::count(frame.upstream.begin(), frame.upstream.end(), 1), 0);
    for (std::size_t k = 0; k < frame.id.size(); ++k) {
      if (frame.upstream[k]) {
        EXPECT_EQ(frame.velocity[k], Point{});
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
