// SPDX-License-Identifier: Apache-2.0
// This metal flows by von Mises and hardens evenly in all directions: linearly, and in addition by
// Voce's law, which saturates (Simo, Comput. Methods Appl. Mech. Engrg. 99 (1992) 61):
//   sigma_y = sigma_0 + H eps_p + Q [1 - exp(-eps_p / eps_Q)].
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "core/host_device.hpp"

namespace kerf {

template <class T>
struct J2Hardening {
  T yield_stress = 0;       // sigma_0, Pa
  T modulus = 0;            // H, Pa
  T saturation_stress = 0;  // Q, Pa
  T saturation_strain = 1;  // eps_Q

  static constexpr std::string_view sentence =
      "Metal by von Mises with linear hardening and Voce's";
  static constexpr bool is_metal = true;
  static constexpr bool depends_on_temperature = false;
  static std::vector<Key> rows() {
    using Law = J2Hardening<double>;
    return {{"yield_strength",
             ValueKind::quantity,
             "Pa",
             "",
             key_range::positive,
             {},
             "",
             "Stress at which it begins to flow",
             stored_in<&Law::yield_stress>},
            {"hardening_modulus",
             ValueKind::quantity,
             "Pa",
             "0 Pa",
             key_range::not_negative,
             {},
             "",
             "Slope H of the strength over plastic strain",
             stored_in<&Law::modulus>},
            {"saturation_stress",
             ValueKind::quantity,
             "Pa",
             "0 Pa",
             key_range::not_negative,
             {},
             "",
             "Q of Voce's hardening Q [1 - exp(-strain / saturation_strain)]",
             stored_in<&Law::saturation_stress>},
            {"saturation_strain",
             ValueKind::number,
             "",
             "1",
             key_range::positive,
             {},
             "",
             "Plastic strain of Voce's hardening",
             stored_in<&Law::saturation_strain>}};
  }

  // Pa; it depends on neither rate nor temperature.
  KERF_FUNCTION T strength(T plastic_strain, T, T) const {
    return yield_stress + modulus * plastic_strain -
           saturation_stress * std::expm1(-plastic_strain / saturation_strain);
  }
  KERF_FUNCTION T first_strength() const { return yield_stress; }

  template <class Other>
  KERF_FUNCTION static J2Hardening from(const J2Hardening<Other>& other) {
    return {static_cast<T>(other.yield_stress), static_cast<T>(other.modulus),
            static_cast<T>(other.saturation_stress), static_cast<T>(other.saturation_strain)};
  }
  bool operator==(const J2Hardening&) const = default;
};

}  // namespace kerf
