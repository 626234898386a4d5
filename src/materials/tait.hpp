// SPDX-License-Identifier: Apache-2.0
// Nearly incompressible water, eq. (15) of Shinohara et al. (2004):
//   p = B [(rho/rho_0)^n - 1],  B = c^2 rho_0 / n,  eqs. (17) to (19).
// It is also the isentrope of a stiffened gas, n its adiabatic exponent and B its pressure at
// infinity, and the equation of Murnaghan (Proc. Natl. Acad. Sci. 30 (1944) 244), with B = K / n,
// for solid that has come loose.
#pragma once

#include <cmath>

#include "exec/host_device.hpp"
#include "particles/medium.hpp"

namespace kerf {

struct Tait {
  template <class T>
  KERF_FUNCTION static T pressure(const Medium<T>& water, T compression) {  // Pa
    return water.tait_coefficient * power_less_one(compression, water.tait_exponent);
  }

  // The compression at which the pressure is this, Pa; 0 for none.
  template <class T>
  KERF_FUNCTION static T compression(const Medium<T>& water, T pressure) {
    if (!(pressure > T(0))) return T(0);
    return std::expm1(std::log1p(pressure / water.tait_coefficient) / water.tait_exponent);
  }

  // Speed of sound at this density, m/s: c^2 = dp/drho.
  template <class T>
  KERF_FUNCTION static T sound_speed(const Medium<T>& water, T compression) {
    const T ratio = T(1) + compression;
    if (water.tait_exponent == usual_exponent) return water.sound_speed * ratio * ratio * ratio;
    return water.sound_speed * std::pow(ratio, T(0.5) * (water.tait_exponent - T(1)));
  }

  // Stored energy per mass, J/kg: the integral of p / rho^2 d rho from rho_0.
  template <class T>
  KERF_FUNCTION static double energy(const Medium<T>& water, double compression) {
    const double n = water.tait_exponent;
    const double ratio = 1.0 + compression;
    return water.tait_coefficient / water.density *
           ((std::pow(ratio, n - 1.0) - 1.0) / (n - 1.0) + 1.0 / ratio - 1.0);
  }

 private:
  static constexpr int usual_exponent = 7;  // of water: powers of it are products

  // (1 + x)^n - 1, with all digits of an x of 1e-5 in single precision.
  template <class T>
  KERF_FUNCTION static T power_less_one(T x, T n) {
    if (n != usual_exponent) return std::expm1(n * std::log1p(x));
    return x * (T(7) + x * (T(21) + x * (T(35) + x * (T(35) + x * (T(21) + x * (T(7) + x))))));
  }
};

}  // namespace kerf
