// SPDX-License-Identifier: Apache-2.0
// The equations of state of matter that has a density, chosen per medium while the program runs:
// pressure, speed of sound and stored energy by the compression rho/rho_0 - 1. All are barotropic.
// Matter that cavitates opens where the pressure would be negative: p = 0, and no energy is stored.
#pragma once

#include "materials/shock_hugoniot.hpp"
#include "materials/tait.hpp"

namespace kerf {

template <class T, class Number>
KERF_FUNCTION bool is_opened(const Medium<T>& medium, Number compression) {
  return medium.cavitates && compression < Number(0);
}

// Pa.
template <class T>
KERF_FUNCTION T pressure_at(const Medium<T>& medium, T compression) {
  if (is_opened(medium, compression)) return T(0);
  switch (medium.equation_of_state) {
    case EquationOfState::tait:
      return Tait::pressure(medium, compression);
    case EquationOfState::shock_hugoniot:
      return ShockHugoniot::pressure(medium, compression);
  }
  return T(0);
}

// m/s, at this density.
template <class T>
KERF_FUNCTION T sound_speed_at(const Medium<T>& medium, T compression) {
  switch (medium.equation_of_state) {
    case EquationOfState::tait:
      return Tait::sound_speed(medium, compression);
    case EquationOfState::shock_hugoniot:
      return ShockHugoniot::sound_speed(medium, compression);
  }
  return medium.sound_speed;
}

// That of the impedance between two particles, m/s. Tait's water is hardly compressed: that at
// rest does, and costs no power per pair.
template <class T>
KERF_FUNCTION T impedance_speed_at(const Medium<T>& medium, T compression) {
  return medium.equation_of_state == EquationOfState::tait ? medium.sound_speed
                                                           : sound_speed_at(medium, compression);
}

// J/kg, stored.
template <class T>
KERF_FUNCTION double energy_at(const Medium<T>& medium, double compression) {
  if (is_opened(medium, compression)) return 0.0;
  switch (medium.equation_of_state) {
    case EquationOfState::tait:
      return Tait::energy(medium, compression);
    case EquationOfState::shock_hugoniot:
      return ShockHugoniot::energy(medium, compression);
  }
  return 0.0;
}

// Whether it is denser than any pressure makes it.
template <class T>
KERF_FUNCTION bool is_too_dense(const Medium<T>& medium, T compression) {
  return medium.equation_of_state == EquationOfState::shock_hugoniot &&
         ShockHugoniot::is_beyond(medium, compression);
}

}  // namespace kerf
