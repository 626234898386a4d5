// SPDX-License-Identifier: Apache-2.0
// Equations of state against their defining integrals and derivatives.
#include <gtest/gtest.h>

#include <cmath>

#include "materials/equation_of_state.hpp"
#include "shinohara2004/hooke_solid.hpp"
#include "support/mixture.hpp"

namespace kerf::test {
namespace {

// Integrates by Simpson's rule.
template <class Function>
double integral(const Function& f, double from, double to) {
  constexpr int cells = 2000;
  const double step = (to - from) / cells;
  double sum = 0.0;
  for (int k = 0; k < cells; ++k) {
    const double a = from + k * step;
    sum += f(a) + 4.0 * f(a + 0.5 * step) + f(a + step);
  }
  return sum * step / 6.0;
}

// Returns the integral of p / rho^2 over rho from rho_0, J/kg.
template <class Pressure>
double energy_by_quadrature(const Pressure& pressure, double density, double compression) {
  const auto integrand = [&](double rho) { return pressure(rho / density - 1.0) / (rho * rho); };
  return integral(integrand, density, density * (1.0 + compression));
}

const double compressions[] = {-0.3, -0.05, -1e-3, 1e-3, 0.05, 0.4};

TEST(Tait, PressureAsPrinted) {
  const auto water = mixture_water(1e-3, 2);
  const double b = 50.0 * 50.0 * 1000.0 / 7.0;  // eqs. (17) to (19)
  for (double x : compressions) {
    const double due = b * (std::pow(1.0 + x, 7.0) - 1.0);  // eq. (15)
    EXPECT_NEAR(water.tait.pressure(water, x), due, 1e-12 * std::abs(due));
  }
  EXPECT_EQ(water.tait.pressure(water, 0.0), 0.0);
}

// Water's exponent of 7 is a product, others are powers.
TEST(Tait, OtherExponents) {
  auto water = mixture_water(1e-3, 2);
  for (double n : {1.4, 4.0, 7.0, 7.15})
    for (double x : compressions) {
      water.tait.exponent = n;
      const double due = water.tait.coefficient * (std::pow(1.0 + x, n) - 1.0);
      EXPECT_NEAR(water.tait.pressure(water, x), due, 1e-12 * std::abs(due));
      const double speed = water.sound_speed * std::pow(1.0 + x, 0.5 * (n - 1.0));
      EXPECT_NEAR(water.tait.sound_speed(water, x), speed, 1e-14 * speed);
    }
}

TEST(Tait, SinglePrecisionKeepsSmallCompressions) {
  const auto water = mixture_water(1e-3, 2);
  Medium<float> single;
  single.tait.coefficient = static_cast<float>(water.tait.coefficient);
  single.tait.exponent = 7.0f;
  const double exact = water.tait.pressure(water, double(1e-6f));
  EXPECT_NEAR(single.tait.pressure(single, 1e-6f), exact, 1e-6 * exact);
}

TEST(Tait, SoundSpeedIsTheSlopeOfPressure) {
  const auto water = mixture_water(1e-3, 2);
  const double step = 1e-6;
  for (double x : compressions) {
    const double slope =
        (water.tait.pressure(water, x + step) - water.tait.pressure(water, x - step)) /
        (2.0 * step * water.density);
    const double c = water.tait.sound_speed(water, x);
    EXPECT_NEAR(c * c, slope, 1e-8 * slope);
  }
  EXPECT_NEAR(water.tait.sound_speed(water, 0.0), 50.0, 1e-12);
}

TEST(Tait, EnergyIsTheWorkOfPressure) {
  const auto water = mixture_water(1e-3, 2);
  for (double x : compressions) {
    const double due = energy_by_quadrature(
        [&](double compression) { return water.tait.pressure(water, compression); }, 1000.0, x);
    // The closed form is a difference of numbers near 1: its rounding is of B / rho_0.
    EXPECT_NEAR(water.tait.energy(water, x), due, 1e-9 * due + 1e-15 * water.tait.coefficient);
    EXPECT_GT(due, 0.0);
  }
}

TEST(Tait, EnergyForAnotherExponent) {
  auto water = mixture_water(1e-3, 2);
  water.tait.exponent = 3.3;
  const double due = energy_by_quadrature(
      [&](double compression) { return water.tait.pressure(water, compression); }, 1000.0, 0.2);
  EXPECT_NEAR(water.tait.energy(water, 0.2), due, 1e-9 * due);
}

TEST(HookePressure, LinearAndItsEnergy) {
  const auto solid = mixture_solid(2e-3, 2, 0);
  for (double x : compressions) {
    EXPECT_NEAR(HookeSolid::pressure(solid, x, false), solid.bulk_modulus * x,
                1e-15 * solid.bulk_modulus);
    const double due = energy_by_quadrature(
        [&](double compression) { return HookeSolid::pressure(solid, compression, false); },
        solid.density, x);
    EXPECT_NEAR(HookeSolid::volumetric_energy(solid, x, false), due,
                1e-9 * due + 1e-15 * solid.bulk_modulus);
  }
}

// c^2 = K / rho_0 is dp/drho.
TEST(HookePressure, SoundSpeed) {
  const auto solid = mixture_solid(2e-3, 2, 0);
  const double slope = HookeSolid::pressure(solid, 0.01, false) / (0.01 * solid.density);
  EXPECT_NEAR(solid.sound_speed * solid.sound_speed, slope, 1e-12 * slope);
}

}  // namespace
}  // namespace kerf::test
