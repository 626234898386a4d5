// SPDX-License-Identifier: Apache-2.0
// The sums of the balance over particles against sums computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/precision.hpp"
#include "parallel/fused_kernel.hpp"
#include "shinohara2004/traits.hpp"
#include "simulation/balance_accumulator.hpp"
#include "standard/traits.hpp"

namespace kerf::test {
namespace {

Medium<double> medium_of(Phase phase, double mass) {
  Medium<double> medium;
  medium.phase = phase;
  medium.mass = mass;
  medium.density = phase == Phase::water ? 1000.0 : 2000.0;
  medium.total_bulk_modulus = medium.bulk_modulus = 3e6;
  medium.shear_modulus = 1e6;
  medium.excess_bulk_modulus = 0.75e6;
  medium.tait.exponent = 7.0;
  medium.tait.coefficient = 2e5;
  return medium;
}

// Water, a solid, a fractured solid and a wall, of 2, 3, 3 and 100 kg/m.
struct FourParticles {
  Particles<2, Double> particles;

  explicit FourParticles(FieldGroups groups) {
    particles.groups = groups;
    const std::vector<Medium<double>> media{
        medium_of(Phase::water, 2.0), medium_of(Phase::solid, 3.0), medium_of(Phase::rigid, 100.0)};
    to_device(media, particles.media);
    std::vector<NewParticle> start(4);
    for (std::size_t k = 0; k < 4; ++k) start[k].source = static_cast<std::uint16_t>(k < 3 ? k : 1);
    start[0].velocity = {3.0, 0.0, 0.0};
    start[1].velocity = {0.0, -2.0, 0.0};
    start[3].velocity = {1.0, 1.0, 0.0};
    particles.append(start, media);
    particles.fractured[3] = 1;
  }
};

// Integral of p / rho^2 d rho from rho_0, by Simpson's rule.
template <class Pressure>
double energy_of(const Pressure& pressure, double density, double compression) {
  constexpr int steps = 2000;
  const double width = compression / steps;
  double sum = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const double x = k * width, weight = k == 0 || k == steps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    sum += weight * pressure(x) / (density * (1.0 + x) * (1.0 + x));
  }
  return sum * width / 3.0;
}
double tait(double x) {
  return 2e5 * (std::pow(1.0 + x, 7.0) - 1.0);
}

TEST(BalanceSums, StateOfTheShinoharaFormulation) {
  FourParticles four(
      {.rate_stress = true, .contact = false, .mirrored = false, .density_losses = false});
  auto& particles = four.particles;
  particles.pressure_work[0] = 0.5;
  particles.pressure_work[3] = 0.25;
  particles.compression[0] = 0.02;
  particles.compression[1] = -0.01;
  particles.compression[3] = -0.01;  // no tension
  auto shear = SymmetricTensor<2, double>::zero();
  shear(0, 0) = 4e3;
  shear(1, 1) = -3e3;
  shear(2, 2) = -1e3;
  shear(0, 1) = 2e3;
  particles.shear[1] = shear;
  BalanceAccumulator<2, Double, Shinohara2004Traits> accumulator;
  accumulator.set_masses({2.0, 3.0, 100.0});
  const Balance now = accumulator.state(particles, {0.0, 0.0});
  EXPECT_DOUBLE_EQ(now.mass_now, 8.0);
  EXPECT_DOUBLE_EQ(now.mass_fractured, 3.0);
  EXPECT_DOUBLE_EQ(now.momentum_now[0], 9.0);
  EXPECT_DOUBLE_EQ(now.momentum_now[1], -3.0);
  EXPECT_DOUBLE_EQ(now.kinetic, 9.0 + 6.0 + 3.0);
  EXPECT_DOUBLE_EQ(now.pressure_work, 2.0 * 0.5 + 3.0 * 0.25);
  EXPECT_NEAR(now.momentum_scale, 6.0 + 6.0 + 3.0 * std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(now.stored_water, 2.0 * energy_of(tait, 1000.0, 0.02), 1e-9);
  const auto hooke = [](double x) { return 3e6 * x; };
  EXPECT_NEAR(now.stored_solid, 3.0 * energy_of(hooke, 2000.0, -0.01), 1e-9);
  // s : s / (4 G rho), with the shear stress twice.
  const double square = 16e6 + 9e6 + 1e6 + 2.0 * 4e6;
  EXPECT_NEAR(now.elastic_deviatoric, 3.0 * square / (4.0 * 1e6 * 2000.0 * 0.99), 1e-12);
}

TEST(BalanceSums, StandardSolidsStoreTheirExcessBulkEnergyByDensity) {
  FourParticles four(
      {.rate_stress = false, .contact = true, .mirrored = false, .density_losses = false});
  auto& particles = four.particles;
  particles.compression[1] = 0.02;
  particles.compression[3] = 0.01;
  BalanceAccumulator<2, Double, StandardTraits> accumulator;
  accumulator.set_masses({2.0, 3.0, 100.0});
  const Balance now = accumulator.state(particles, {0.0, 0.0});
  const double intact = 0.25 * energy_of(tait, 2000.0, 0.02);
  const double detached = energy_of(tait, 2000.0, 0.01);
  EXPECT_NEAR(now.stored_solid, 3.0 * (intact + detached), 1e-10);
  EXPECT_EQ(now.elastic_deviatoric, 0.0);
}

TEST(BalanceSums, StepAddsImpulsesWorkAndDissipation) {
  FourParticles four(
      {.rate_stress = true, .contact = false, .mirrored = false, .density_losses = false});
  auto& particles = four.particles;
  const double dt = 0.1;
  const Vector<2, double> gravity{0.0, -10.0};
  for (Index i = 0; i < 4; ++i) {
    particles.start_position[i] = particles.position[i];
    particles.start_velocity[i] = particles.velocity[i];
    particles.acceleration[i] = Vector<2, double>{0.0, -10.0};
    particles.repulsion[i] = Vector<2, double>::zero();
    particles.pressure_power[i] = particles.artificial_power[i] = 0.0;
    particles.fracture_loss[i] = 0.0;
    particles.velocity_gradient[i] = Matrix<2, double>::zero();
  }
  particles.position[1] = Vector<2, double>{0.3, -0.2};
  particles.acceleration[0] = Vector<2, double>{5.0, -4.0};
  particles.repulsion[0] = Vector<2, double>{0.0, 2.0};
  particles.pressure_power[0] = 7.0;
  particles.artificial_power[1] = 4.0;
  particles.fracture_loss[3] = 0.5;
  BalanceAccumulator<2, Double, Shinohara2004Traits> accumulator;
  accumulator.set_masses({2.0, 3.0, 100.0});
  accumulator.accumulate_step(particles, gravity, dt, NoOp{}, NoOp{});
  const Balance& sum = accumulator.totals();
  EXPECT_NEAR(sum.impulse_gravity[1], -10.0 * 8.0 * dt, 1e-14);
  EXPECT_NEAR(sum.impulse_rigid[1], 2.0 * 2.0 * dt, 1e-15);
  EXPECT_NEAR(sum.constraint_scale, 2.0 * 2.0 * dt, 1e-15);
  // The water's acceleration is (5, -4), of which (0, -10) is gravity and (0, 2) is due to the
  // wall.
  EXPECT_NEAR(sum.impulse_water[0], -2.0 * 5.0 * dt, 1e-15);
  EXPECT_NEAR(sum.impulse_water[1], -2.0 * 4.0 * dt, 1e-15);
  EXPECT_NEAR(sum.work_gravity, 3.0 * 10.0 * 0.2, 1e-14);
  EXPECT_NEAR(sum.dissipated_artificial, 3.0 * 4.0 * dt, 1e-15);
  EXPECT_NEAR(sum.dissipated_fracture, 0.5, 1e-15);
  EXPECT_NEAR(double(particles.pressure_work[0]), 0.7, 1e-15);
}

// In the standard formulation pressure work is what the densities store of it.
TEST(BalanceSums, StepSplitsThePressureWork) {
  FourParticles four(
      {.rate_stress = false, .contact = true, .mirrored = false, .density_losses = true});
  auto& particles = four.particles;
  const double dt = 0.1;
  for (Index i = 0; i < 4; ++i) {
    particles.start_position[i] = particles.position[i];
    particles.acceleration[i] = particles.repulsion[i] = Vector<2, double>::zero();
    particles.damping_acceleration[i] = Vector<2, double>::zero();
    particles.pressure_power[i] = 0.0;
    particles.continuity_loss[i] = particles.reinitialisation_loss[i] = 0.0;
  }
  particles.position[1] += Vector<2, double>{0.3, -0.2};
  particles.damping_acceleration[1] = Vector<2, double>{-2.0, 1.0};
  particles.pressure_work[0] = 0.5;
  particles.pressure_power[0] = 7.0;
  particles.continuity_loss[0] = 0.4;
  particles.reinitialisation_loss[0] = 0.25;
  particles.continuity_loss[3] = -0.1;
  BalanceAccumulator<2, Double, StandardTraits> accumulator;
  accumulator.set_masses({2.0, 3.0, 100.0});
  accumulator.accumulate_step(particles, {0.0, 0.0}, dt, NoOp{}, NoOp{});
  const Balance& sum = accumulator.totals();
  EXPECT_NEAR(sum.dissipated_density, 2.0 * 0.4 - 3.0 * 0.1, 1e-14);
  EXPECT_NEAR(sum.dissipated_reinitialisation, 2.0 * 0.25, 1e-14);
  EXPECT_NEAR(double(particles.pressure_work[0]), 0.5 + 0.7 - 0.4 - 0.25, 1e-14);
  EXPECT_NEAR(double(particles.pressure_work[3]), 0.1, 1e-14);
  // Dissipative forces take minus force times displacement, of the same particle as above.
  EXPECT_NEAR(sum.dissipated_artificial, 3.0 * (2.0 * 0.3 + 1.0 * 0.2), 1e-14);
}

// A rigid body that moves works on what it pushes, and so does its friction, of which the other
// part is dissipated.
TEST(BalanceSums, StepAddsTheWorkOfMovingWalls) {
  FourParticles four({.rate_stress = false,
                      .contact = true,
                      .mirrored = false,
                      .density_losses = false,
                      .moving_walls = true});
  auto& particles = four.particles;
  for (Index i = 0; i < 4; ++i) {
    particles.start_position[i] = particles.position[i];
    particles.acceleration[i] = particles.repulsion[i] = Vector<2, double>::zero();
    particles.damping_acceleration[i] = Vector<2, double>::zero();
    particles.pressure_power[i] = 0.0;
    particles.rigid_power[i] = {};
  }
  particles.rigid_power[0] = {3.0, 0.5, 0.0};
  particles.rigid_power[1] = {0.0, -0.25, 2.0};
  BalanceAccumulator<2, Double, StandardTraits> accumulator;
  accumulator.set_masses({2.0, 3.0, 100.0});
  accumulator.accumulate_step(particles, {0.0, 0.0}, 0.1, NoOp{}, NoOp{});
  EXPECT_NEAR(accumulator.totals().work_constraint, 0.1 * (2.0 * 3.5 + 3.0 * 1.75), 1e-14);
  EXPECT_NEAR(accumulator.totals().dissipated_artificial, 0.1 * (2.0 * 0.5 - 3.0 * 0.25), 1e-14);
}

TEST(BalanceSums, OutflowRemovesItsMassMomentumAndEnergy) {
  FourParticles four(
      {.rate_stress = true, .contact = false, .mirrored = false, .density_losses = false});
  auto& particles = four.particles;
  particles.flags[0] = flag::outside;
  particles.flags[1] = flag::erased;
  particles.pressure_work[0] = 0.5;
  BalanceAccumulator<2, Double, Shinohara2004Traits> accumulator;
  accumulator.set_masses({2.0, 3.0, 100.0});
  accumulator.accumulate_outflow(particles);
  accumulator.accumulate_inflow(0, {0.0, -4.0, 0.0});
  const Balance& sum = accumulator.totals();
  EXPECT_EQ(sum.mass_out, 2.0);
  EXPECT_EQ(sum.mass_erased, 3.0);
  EXPECT_EQ(sum.momentum_out[0], 6.0);
  EXPECT_EQ(sum.momentum_out[1], -6.0);
  EXPECT_DOUBLE_EQ(sum.energy_out, 9.0 + 1.0 + 6.0);
  EXPECT_EQ(sum.mass_in, 2.0);
  EXPECT_EQ(sum.momentum_in[1], -8.0);
  EXPECT_EQ(sum.energy_in, 16.0);
}

}  // namespace
}  // namespace kerf::test
