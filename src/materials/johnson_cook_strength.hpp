// SPDX-License-Identifier: Apache-2.0
// Strength of a metal at high rates (Johnson & Cook, Proc. 7th Int. Symp. on Ballistics, The Hague
// (1983) 541):
//   sigma_y = (A + B eps_p^n) (1 + C ln rate*) (1 - T*^m),   rate* = rate / rate_0.
// Rates below rate_0 count as rate_0, or the logarithm would take the strength below zero.
#pragma once

#include <cmath>

#include "exec/host_device.hpp"

namespace kerf {

// 1 + C ln(rate / rate_0), of strength and of failure strain.
template <class T>
KERF_FUNCTION T johnson_cook_rate_factor(T coefficient, T rate, T reference_rate) {
  return rate > reference_rate ? T(1) + coefficient * std::log(rate / reference_rate) : T(1);
}

template <class T>
struct JohnsonCookStrength {
  T yield_stress = 0;        // A, Pa
  T hardening = 0;           // B, Pa
  T hardening_exponent = 1;  // n
  T rate_coefficient = 0;    // C
  T reference_rate = 1;      // rate_0, 1/s
  T thermal_exponent = 1;    // m

  // Pa, at T* within 0 and 1.
  KERF_FUNCTION T strength(T plastic_strain, T rate, T homologous) const {
    const T cold = yield_stress + hardening * std::pow(plastic_strain, hardening_exponent);
    return cold * johnson_cook_rate_factor(rate_coefficient, rate, reference_rate) *
           (T(1) - std::pow(homologous, thermal_exponent));
  }

  template <class Other>
  KERF_FUNCTION static JohnsonCookStrength from(const JohnsonCookStrength<Other>& other) {
    return {static_cast<T>(other.yield_stress),       static_cast<T>(other.hardening),
            static_cast<T>(other.hardening_exponent), static_cast<T>(other.rate_coefficient),
            static_cast<T>(other.reference_rate),     static_cast<T>(other.thermal_exponent)};
  }
};

}  // namespace kerf
