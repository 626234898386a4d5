// SPDX-License-Identifier: Apache-2.0
// Water with shock speeds c + s u: its pressure, energy and sound speed are consistent, and a shock
// has the speed and the pressure of the balances of mass and momentum.
#include "materials/shock_hugoniot.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "materials/equation_of_state.hpp"

namespace kerf::test {
namespace {

constexpr double rho_0 = 1000.0, c_0 = 1481.0, s = 1.975;

template <class T>
BarotropicMatter<T> shocked_water() {
  BarotropicMatter<T> water;
  water.equation_of_state = EquationOfState::shock_hugoniot;
  water.cavitates = true;
  water.density = T(rho_0);
  water.sound_speed = T(c_0);
  water.shock_hugoniot.slope = T(s);
  return water;
}

const double shock_compressions[] = {1e-4, 1e-2, 0.05, 0.15, 0.3, 0.5};

// The fifth-order central difference: its error at steps of 1e-3 x is of 1e-12 relative.
template <class Function>
double slope(const Function& f, double x) {
  const double h = 1e-3 * x;
  return (f(x - 2.0 * h) - 8.0 * f(x - h) + 8.0 * f(x + h) - f(x + 2.0 * h)) / (12.0 * h);
}

TEST(ShockHugoniot, PressureIsTheSlopeOfEnergy) {
  const auto water = shocked_water<double>();
  for (const double x : shock_compressions) {
    const double rho = rho_0 * (1.0 + x);
    const double by_energy =
        rho * rho / rho_0 * slope([&](double at) { return energy_at(water, at); }, x);
    const double pressure = pressure_at(water, x);
    // At 1e-4 the energy is a difference that loses eight digits.
    EXPECT_NEAR(by_energy, pressure, (x < 1e-3 ? 1e-5 : 1e-8) * pressure);
  }
}

TEST(ShockHugoniot, SoundSpeedIsTheSlopeOfPressure) {
  const auto water = shocked_water<double>();
  for (const double x : shock_compressions) {
    const double square = slope([&](double at) { return pressure_at(water, at); }, x) / rho_0;
    const double sound_speed = sound_speed_at(water, x);
    EXPECT_NEAR(sound_speed * sound_speed, square, 1e-8 * square);
  }
  EXPECT_NEAR(sound_speed_at(water, 0.0), c_0, 1e-12 * c_0);
}

// Behind a shock of p = rho_0 U u the density is rho_0 U / (U - u) by the balances of mass and
// momentum.
TEST(ShockHugoniot, ShocksRunAtTheirSpeed) {
  const auto water = shocked_water<double>();
  for (const double u : {1.0, 100.0, 300.0, 600.0, 900.0}) {
    const double speed = c_0 + s * u;
    const double due = rho_0 * speed * u;
    EXPECT_NEAR(pressure_at(water, u / (speed - u)), due, 1e-9 * due);
  }
}

// Shocks of real water, computed from the equation of state IAPWS-95 (Wagner & Pruss, J. Phys.
// Chem. Ref. Data 31 (2002) 387) by the balances of mass, momentum and energy, from 20 C and 0.1
// MPa.
TEST(ShockHugoniot, AgreesWithMeasurementsOfWater) {
  const struct {
    double u, speed;
  } shocks[] = {{100, 1670.8}, {200, 1874.3}, {300, 2077.8}, {400, 2278.0}, {500, 2475.6},
                {600, 2671.3}, {700, 2865.1}, {800, 3056.7}, {900, 3245.7}};
  for (const auto& shock : shocks) EXPECT_NEAR(c_0 + s * shock.u, shock.speed, 0.005 * shock.speed);
}

TEST(ShockHugoniot, SinglePrecisionKeepsSmallCompressions) {
  const auto single = shocked_water<float>();
  const double due = pressure_at(shocked_water<double>(), double(1e-6f));
  EXPECT_NEAR(pressure_at(single, 1e-6f), due, 1e-6 * due);
}

TEST(ShockHugoniot, CavitatesUnderTension) {
  const auto water = shocked_water<double>();
  EXPECT_EQ(pressure_at(water, -0.2), 0.0);
  EXPECT_EQ(energy_at(water, -0.2), 0.0);
  EXPECT_EQ(sound_speed_at(water, -0.5), c_0);
}

// The pressure is infinite at rho_0 s / (s - 1).
TEST(ShockHugoniot, ReachesNoGreaterDensity) {
  const auto water = shocked_water<double>();
  EXPECT_FALSE(is_too_dense(water, 0.99 / (s - 1.0)));
  EXPECT_TRUE(is_too_dense(water, 1.01 / (s - 1.0)));
  EXPECT_GT(pressure_at(water, 0.99 / (s - 1.0)), 1e3 * rho_0 * c_0 * c_0);
}

}  // namespace
}  // namespace kerf::test
