// SPDX-License-Identifier: Apache-2.0
// The damage D of a ductile metal (Johnson & Cook, Engng Fract. Mech. 21 (1985) 31) grows by
// d eps_p / eps_f, and at D = 1 the metal fails.
//   eps_f = [D1 + D2 exp(D3 sigma*)] (1 + D4 ln rate*) (1 + D5 T*),   sigma* = mean stress / q.
// The formula was measured up to sigma* = 1.5 and is held there; rate* as for the strength. Damage
// takes nothing off the strength before the metal fails.
#pragma once

#include <cmath>
#include <vector>

#include "materials/johnson_cook_strength.hpp"

namespace kerf {

template <class T>
struct JohnsonCookDamage {
  T constant = 0;              // D1
  T triaxial = 0;              // D2
  T triaxial_exponent = 0;     // D3, negative: tension makes brittle
  T rate_coefficient = 0;      // D4
  T thermal_coefficient = 0;   // D5
  T reference_rate = 1;        // rate_0, 1/s
  T least_failure_strain = 0;  // eps_f is not below this; 0 = no damage at all

  // The keys of every metal.
  static std::vector<Key> rows() {
    using Law = JohnsonCookDamage<double>;
    return {
        {"damage_d1",
         ValueKind::number,
         "",
         "0",
         key_range::any,
         {},
         "",
         "D1 of Johnson & Cook's plastic strain at failure; D1 to D5 need a least_plastic_failure",
         stored_in<&Law::constant>},
        {"damage_d2",
         ValueKind::number,
         "",
         "0",
         key_range::any,
         {},
         "",
         "D2 of Johnson & Cook, before exp(D3 p/q)",
         stored_in<&Law::triaxial>},
        {"damage_d3",
         ValueKind::number,
         "",
         "0",
         key_range::any,
         {},
         "",
         "D3 of Johnson & Cook, of the triaxiality",
         stored_in<&Law::triaxial_exponent>},
        {"damage_d4",
         ValueKind::number,
         "",
         "0",
         key_range::any,
         {},
         "",
         "D4 of Johnson & Cook, of the rate",
         stored_in<&Law::rate_coefficient>},
        {"damage_d5",
         ValueKind::number,
         "",
         "0",
         key_range::any,
         {},
         "",
         "D5 of Johnson & Cook, of the temperature",
         stored_in<&Law::thermal_coefficient>},
        {"least_plastic_failure",
         ValueKind::number,
         "",
         "0",
         key_range::from_zero_to(100.0),
         {},
         "",
         "Least plastic strain at failure that D1 to D5 may give, which switches their damage on; "
         "0 = none",
         stored_in<&Law::least_failure_strain>}};
  }

  KERF_FUNCTION bool is_on() const { return least_failure_strain > T(0); }

  // eps_f at q >= 0 and T* within 0 and 1.
  KERF_FUNCTION T failure_strain(T mean, T equivalent, T rate, T homologous) const {
    const T most = T(1.5), least = T(-10);  // the least only keeps the exponential finite
    const T triaxiality = !(mean < most * equivalent)    ? most
                          : !(mean > least * equivalent) ? least
                                                         : mean / equivalent;
    const T cold = constant + triaxial * std::exp(triaxial_exponent * triaxiality);
    const T strain = cold * johnson_cook_rate_factor(rate_coefficient, rate, reference_rate) *
                     (T(1) + thermal_coefficient * homologous);
    return strain > least_failure_strain ? strain : least_failure_strain;
  }

  template <class Other>
  KERF_FUNCTION static JohnsonCookDamage from(const JohnsonCookDamage<Other>& other) {
    return {static_cast<T>(other.constant),
            static_cast<T>(other.triaxial),
            static_cast<T>(other.triaxial_exponent),
            static_cast<T>(other.rate_coefficient),
            static_cast<T>(other.thermal_coefficient),
            static_cast<T>(other.reference_rate),
            static_cast<T>(other.least_failure_strain)};
  }
  bool operator==(const JohnsonCookDamage&) const = default;
};

}  // namespace kerf
