// SPDX-License-Identifier: Apache-2.0
// The strength of a metal at high rates (Johnson & Cook, Proc. 7th Int. Symp. on Ballistics, The
// Hague (1983) 541):
//   sigma_y = (A + B eps_p^n) (1 + C ln rate*) (1 - T*^m),   rate* = rate / rate_0.
// Rates below rate_0 count as rate_0, or the logarithm would take the strength below zero.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "core/host_device.hpp"

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

  static constexpr std::string_view sentence =
      "Metal at high rates by Johnson & Cook, sigma_y = (A + B eps_p^n) (1 + C ln rate*) (1 - "
      "T*^m)";
  static constexpr bool is_metal = true;
  static constexpr bool depends_on_temperature = true;
  static std::vector<Key> rows() {
    using Law = JohnsonCookStrength<double>;
    return {{"yield_strength",
             ValueKind::quantity,
             "Pa",
             "",
             key_range::positive,
             {},
             "",
             "A of Johnson & Cook, the stress at which it begins to flow",
             stored_in<&Law::yield_stress>},
            {"hardening_coefficient",
             ValueKind::quantity,
             "Pa",
             "0 Pa",
             key_range::not_negative,
             {},
             "",
             "B of Johnson & Cook",
             stored_in<&Law::hardening>},
            {"hardening_exponent",
             ValueKind::number,
             "",
             "1",
             key_range::up_to(10.0),
             {},
             "",
             "n of Johnson & Cook",
             stored_in<&Law::hardening_exponent>},
            {"rate_coefficient",
             ValueKind::number,
             "",
             "0",
             key_range::from_zero_to(1.0),
             {},
             "",
             "C of Johnson & Cook",
             stored_in<&Law::rate_coefficient>},
            {"reference_rate",
             ValueKind::quantity,
             "s-1",
             "1 s-1",
             key_range::positive,
             {},
             "",
             "Strain rate at and below which the rate does not count",
             stored_in<&Law::reference_rate>},
            {"thermal_exponent",
             ValueKind::number,
             "",
             "1",
             key_range::up_to(10.0),
             {},
             "",
             "m of Johnson & Cook",
             stored_in<&Law::thermal_exponent>}};
  }

  // Pa, at T* within 0 and 1.
  KERF_FUNCTION T strength(T plastic_strain, T rate, T homologous) const {
    const T cold = yield_stress + hardening * std::pow(plastic_strain, hardening_exponent);
    return cold * johnson_cook_rate_factor(rate_coefficient, rate, reference_rate) *
           (T(1) - std::pow(homologous, thermal_exponent));
  }
  KERF_FUNCTION T first_strength() const { return yield_stress; }

  template <class Other>
  KERF_FUNCTION static JohnsonCookStrength from(const JohnsonCookStrength<Other>& other) {
    return {static_cast<T>(other.yield_stress),       static_cast<T>(other.hardening),
            static_cast<T>(other.hardening_exponent), static_cast<T>(other.rate_coefficient),
            static_cast<T>(other.reference_rate),     static_cast<T>(other.thermal_exponent)};
  }
  bool operator==(const JohnsonCookStrength&) const = default;
};

}  // namespace kerf
