// SPDX-License-Identifier: Apache-2.0
// Strength of a metal that flows by von Mises and hardens evenly in all directions: linear, and on
// top of it Voce's law, which saturates (Simo, Comput. Methods Appl. Mech. Engrg. 99 (1992) 61):
//   sigma_y = sigma_0 + H eps_p + Q [1 - exp(-eps_p / eps_Q)].
#pragma once

#include <cmath>

#include "exec/host_device.hpp"

namespace kerf {

template <class T>
struct J2Hardening {
  T yield_stress = 0;       // sigma_0, Pa
  T modulus = 0;            // H, Pa
  T saturation_stress = 0;  // Q, Pa
  T saturation_strain = 1;  // eps_Q

  // Pa; neither rate nor temperature counts.
  KERF_FUNCTION T strength(T plastic_strain, T, T) const {
    return yield_stress + modulus * plastic_strain -
           saturation_stress * std::expm1(-plastic_strain / saturation_strain);
  }

  template <class Other>
  KERF_FUNCTION static J2Hardening from(const J2Hardening<Other>& other) {
    return {static_cast<T>(other.yield_stress), static_cast<T>(other.modulus),
            static_cast<T>(other.saturation_stress), static_cast<T>(other.saturation_strain)};
  }
};

}  // namespace kerf
