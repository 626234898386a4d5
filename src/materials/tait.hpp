// SPDX-License-Identifier: Apache-2.0
// Tait's equation of state holds for nearly incompressible water, eq. (15) of Shinohara et al.
// (2004):
//   p = B [(rho/rho_0)^n - 1],  B = c^2 rho_0 / n,  eqs. (17) to (19).
// It is also the isentrope of a stiffened gas, n its adiabatic exponent and B its pressure at
// infinity, and the equation of Murnaghan (Proc. Natl. Acad. Sci. 30 (1944) 244), with B = K / n,
// for detached particles of a solid.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "core/host_device.hpp"
#include "materials/law_arguments.hpp"

namespace kerf {

template <class T>
struct Tait {
  T exponent = T(7);  // n, 1
  T coefficient = 0;  // B, Pa

  static constexpr std::string_view sentence =
      "Weakly compressible water, p = B [(rho/rho_0)^n - 1], eq. (15)";
  static constexpr bool is_weakly_compressible = true;
  static std::vector<Key> rows() {
    return {{"tait_exponent",
             ValueKind::number,
             "",
             "7",
             {1.0, 15.0, true},
             {},
             "tait water+shinohara2004",
             "Exponent n of the equation of state, eq. (15)",
             stored_in<&Tait<double>::exponent>}};
  }
  void derive(const BodyNumbers& body) {
    coefficient = body.sound_speed * body.sound_speed * body.density / exponent;
  }

  KERF_FUNCTION T pressure(const RestState<T>&, T compression) const {  // Pa
    return coefficient * power_less_one(compression, exponent);
  }

  // The compression rho/rho_0 - 1 at a pressure in Pa; 0 where that is not positive.
  KERF_FUNCTION T compression(T pressure) const {
    if (!(pressure > T(0))) return T(0);
    return std::expm1(std::log1p(pressure / coefficient) / exponent);
  }

  // Sound speed at this density, m/s: c^2 = dp/drho.
  template <class Number>
  KERF_FUNCTION Number sound_speed(const RestState<T>& rest, Number compression) const {
    const Number ratio = Number(1) + compression;
    if (exponent == usual_exponent) return rest.sound_speed * ratio * ratio * ratio;
    return rest.sound_speed * std::pow(ratio, T(0.5) * (exponent - T(1)));
  }

  // Stored energy per mass, J/kg: the integral of p / rho^2 d rho from rho_0.
  KERF_FUNCTION double energy(const RestState<T>& rest, double compression) const {
    const double n = exponent;
    const double ratio = 1.0 + compression;
    return coefficient / rest.density *
           ((std::pow(ratio, n - 1.0) - 1.0) / (n - 1.0) + 1.0 / ratio - 1.0);
  }

  // Any density has a pressure.
  KERF_FUNCTION bool is_beyond(T) const { return false; }

  template <class Other>
  KERF_FUNCTION static Tait from(const Tait<Other>& other) {
    return {static_cast<T>(other.exponent), static_cast<T>(other.coefficient)};
  }
  bool operator==(const Tait&) const = default;

 private:
  static constexpr int usual_exponent = 7;  // of water: powers of it are products

  // (1 + x)^n - 1, with all digits of an x of 1e-5 in single precision.
  KERF_FUNCTION static T power_less_one(T x, T n) {
    if (n != usual_exponent) return std::expm1(n * std::log1p(x));
    return x * (T(7) + x * (T(21) + x * (T(35) + x * (T(35) + x * (T(21) + x * (T(7) + x))))));
  }
};

}  // namespace kerf
