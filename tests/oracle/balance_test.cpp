// SPDX-License-Identifier: Apache-2.0
// The balance of short runs against values computed by hand or from frames.
#include "simulation/balance.hpp"

#include <cmath>
#include <numbers>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

// Returns the rounding error of sums over some thousand steps.
double balance_rounding(PrecisionKind precision) {
  return precision == PrecisionKind::mixed ? 1e-6 : 1e-12;
}

// Returns the momentum as a sum over a frame, with the masses of the case.
std::array<double, 3> momentum_of(const Frame& frame, const std::vector<double>& mass) {
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < frame.id.size(); ++k)
    for (std::size_t a = 0; a < 3; ++a)
      if (frame.category[k] != Category::rigid)
        sum[a] += mass[frame.source[k]] * frame.velocity[k][a];
  return sum;
}

void expect_terms_balanced(const Balance& now, PrecisionKind precision) {
  const double mass = now.mass_initial + now.mass_in;
  EXPECT_NEAR(now.mass_now + now.mass_out + now.mass_erased, mass, 1e-12 * mass);
  EXPECT_LE(std::abs(now.mass_error()), 1e-12);
  for (std::size_t a = 0; a < 3; ++a) {
    const double due = now.momentum_initial[a] + now.momentum_in[a] - now.momentum_out[a] +
                       now.impulse_gravity[a] + now.impulse_rigid[a] + now.impulse_constraint[a];
    EXPECT_NEAR(now.momentum_now[a], due, balance_rounding(precision) * now.momentum_scale);
  }
  EXPECT_LE(now.momentum_error(), balance_rounding(precision));
}

// Runs a jet on a block on a plate, with gravity, back_flow_removal and a domain that water leaves.
void run_all_terms(int dimension, PrecisionKind precision, int steps) {
  Case c = jet_on_block(dimension, precision);
  c.back_flow_removal = BackFlowRemoval{};
  // A body with prescribed motion loads the block from the side; a drop leaves the domain.
  const double z = dimension == 3 ? 0.004 : 0.0;
  c.bodies.push_back(
      body("pusher", Role::elastic, box({-0.0118, 0.002, -z}, {-0.0098, 0.006, z}), 1e-3));
  c.bodies.back().displacement = {"0.5*t", "0", "0"};
  c.bodies.push_back(
      body("drop", Role::water, box({0.006, 0.02, -0.5 * z}, {0.01, 0.024, 0.5 * z}), 1e-3));
  c.bodies.back().velocity = {"4", "1", "0"};
  const auto simulation = make_simulation(c);
  Balance before = simulation->balance();
  for (int n = 0; n < steps; ++n) {
    simulation->advance();
    if (n % 10 != 0) continue;
    const Balance now = simulation->balance();
    ASSERT_GE(now.dissipated_artificial, before.dissipated_artificial);
    ASSERT_GE(now.dissipated_viscous, before.dissipated_viscous);
    ASSERT_GE(now.dissipated_fracture, before.dissipated_fracture);
    expect_terms_balanced(now, precision);
    before = now;
  }
  const Balance now = simulation->balance();
  std::printf("mass %.1e, momentum %.1e, energy %.1e, in %.3g out %.3g erased %.3g kg\n",
              now.mass_error(), now.momentum_error(), now.energy_drift(), now.mass_in, now.mass_out,
              now.mass_erased);
  EXPECT_GT(now.mass_in, 0.0);
  EXPECT_GT(now.mass_out, 0.0);
  EXPECT_GT(now.mass_erased, 0.0);
  EXPECT_GT(now.mass_fractured, 0.0);
  EXPECT_GT(now.dissipated_viscous, 0.0);
  EXPECT_NE(now.work_constraint, 0.0);
  EXPECT_GT(now.impulse_rigid[1], 0.0);
  EXPECT_LE(std::abs(now.energy_drift()), 0.02);
  // The mass of the jet is exact up to rounding: rho V A t = in + carried.
  const double area = dimension == 2 ? 5e-3 : std::numbers::pi * 25e-6 / 4.0;
  const double due = 1000.0 * 5.0 * area * simulation->time();
  EXPECT_NEAR(now.jet_mass_due, due, 1e-12 * due);
  EXPECT_NEAR(now.mass_in + now.jet_mass_carried, due, 1e-12 * due);
  EXPECT_GE(now.jet_mass_carried, 0.0);
}
TEST(BalanceWithAllTerms, Mixed2D) {
  run_all_terms(2, PrecisionKind::mixed, 1500);
}
TEST(BalanceWithAllTerms, Double2D) {
  run_all_terms(2, PrecisionKind::double_precision, 1500);
}
TEST(BalanceWithAllTerms, Mixed3D) {
  run_all_terms(3, PrecisionKind::mixed, 600);
}
TEST(BalanceWithAllTerms, Double3D) {
  run_all_terms(3, PrecisionKind::double_precision, 600);
}

// The totals of the balance equal independent sums over the frame.
TEST(Balance, AgreesWithTheFrame) {
  Case c = jet_on_block(2, PrecisionKind::double_precision);
  const auto simulation = make_simulation(c);
  take_steps(*simulation, 400);
  const Frame frame = simulation->frame();
  const Balance balance = simulation->balance();
  const std::vector<double> mass{940.0 * 1e-6, 0.0, 1000.0 * 25e-8};
  const auto momentum = momentum_of(frame, mass);
  double kinetic = 0.0, total = 0.0, fractured = 0.0;
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    const double m = mass[frame.source[k]];
    const auto& v = frame.velocity[k];
    kinetic += 0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    total += m;
    if (frame.category[k] == Category::fractured) fractured += m;
  }
  EXPECT_NEAR(balance.mass_now, total, 1e-12 * total);
  EXPECT_NEAR(balance.mass_fractured, fractured, 1e-12 * total);
  EXPECT_NEAR(balance.kinetic, kinetic, 1e-12 * kinetic);
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_NEAR(balance.momentum_now[a], momentum[a], 1e-12 * balance.momentum_scale);
}

// In free fall the momentum is m g t and the energy m g h.
TEST(Balance, FreeFallGainsMomentumAndEnergy) {
  for (PrecisionKind precision : both_precisions) {
    Case c = empty_case(2, precision);
    c.gravity = {0.5, -9.81, 0.0};
    c.bodies = {body("block", Role::elastic, box({0.0, 0.0, 0.0}, {0.02, 0.02, 0.0}), 2e-3)};
    const auto simulation = make_simulation(c);
    take_steps(*simulation, 500);
    const double t = simulation->time(), m = 940.0 * 4e-4;
    const Balance now = simulation->balance();
    const double digits = precision == PrecisionKind::mixed ? 1e-6 : 1e-12;
    const double gravity = std::hypot(0.5, 9.81);
    EXPECT_NEAR(now.impulse_gravity[1], -9.81 * m * t, 1e-12 * m * gravity * t);
    EXPECT_NEAR(now.momentum_now[0], 0.5 * m * t, 10.0 * digits * m * gravity * t);
    EXPECT_NEAR(now.momentum_now[1], -9.81 * m * t, 10.0 * digits * m * gravity * t);
    const double fallen = 0.5 * m * gravity * gravity * t * t;
    EXPECT_NEAR(now.work_gravity, fallen, 100.0 * digits * fallen);
    EXPECT_NEAR(now.kinetic, fallen, 100.0 * digits * fallen);
    EXPECT_LE(std::abs(now.energy_drift()), 100.0 * digits);
  }
}

// A block rebounds from a plate: the impulse of the plate is the change of momentum, and the energy
// is that at the start.
TEST(Balance, PlateImpulseReversesTheMomentum) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.materials[0].failure_strain = 0.0;
  c.bodies = {body("block", Role::elastic, box({-0.01, 0.002, 0.0}, {0.01, 0.022, 0.0}), 2e-3),
              body("plate", Role::rigid, box({-0.02, -0.004, 0.0}, {0.02, 0.0, 0.0}), 2e-3)};
  c.bodies[0].velocity = {"0", "-0.5", "0"};
  const auto simulation = make_simulation(c);
  while (simulation->time() < 0.02) simulation->advance();
  const Balance now = simulation->balance();
  const double thrown = 0.5 * 940.0 * 4e-4;
  EXPECT_GT(now.momentum_now[1], 0.0);  // after the rebound
  EXPECT_NEAR(now.impulse_rigid[1], thrown + now.momentum_now[1], 1e-12 * thrown);
  EXPECT_LE(std::abs(now.energy_drift()), 0.01);
  EXPECT_EQ(now.force_rigid[1], 0.0);  // the block has left the plate
}

// A body that is in the repulsive range of the plate at the start has that potential energy.
TEST(Balance, InitialEnergyHasThePotentialOfThePlate) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.bodies = {body("block", Role::elastic, box({-0.01, 0.0, 0.0}, {0.01, 0.02, 0.0}), 2e-3),
              body("plate", Role::rigid, box({-0.02, -0.004, 0.0}, {0.02, 0.0, 0.0}), 2e-3)};
  c.bodies[0].offset = {0.0, -5e-4, 0.0};
  const auto simulation = make_simulation(c);
  const Balance start = simulation->balance();
  ASSERT_GT(start.rigid_potential, 0.0);
  EXPECT_NEAR(start.energy_initial, start.energy_total(), 1e-12 * start.energy_total());
}

// A square of water is compressed and expands: the energy stored by the equation of state is the
// work against pressure, for one medium of nearly uniform density.
TEST(Balance, PressureWorkIsStored) {
  for (PrecisionKind precision : both_precisions) {
    Case c = empty_case(2, precision);
    c.materials[1].artificial_linear = 0.0;
    c.materials[1].viscosity = 0.0;
    c.bodies = {body("drop", Role::water, box({-0.01, -0.01, 0.0}, {0.01, 0.01, 0.0}), 1e-3)};
    c.bodies[0].velocity = {"-50*x", "-50*y", "0"};
    const auto simulation = make_simulation(c);
    double greatest = 0.0, gap = 0.0;
    for (int n = 0; n < 60; ++n) {
      simulation->advance();
      const Balance now = simulation->balance();
      greatest = std::max(greatest, now.pressure_work);
      gap = std::max(gap, std::abs(now.stored_water - now.pressure_work));
    }
    const Balance now = simulation->balance();
    EXPECT_GT(greatest, 0.1 * now.energy_initial);
    EXPECT_LE(gap, 0.02 * greatest);
    EXPECT_LE(std::abs(now.energy_drift()), 0.01);
  }
}

}  // namespace
}  // namespace kerf::test
