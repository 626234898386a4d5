// SPDX-License-Identifier: Apache-2.0
// The equations of state of matter that has a density. A medium chooses one of them by the word of
// the case file. All are barotropic: they depend on the compression rho/rho_0 - 1 alone. Each has
// (core/law_list.hpp)
//   pressure(rest, compression)      Pa
//   sound_speed(rest, compression)   m/s, of one number or of a SIMD register
//   energy(rest, compression)        stored, J/kg
//   is_beyond(compression)           whether no pressure reaches this density
//   is_weakly_compressible           whether the sound speed at rest does for all pairs
// Matter that cavitates opens where the pressure would be negative: p = 0, and no energy is stored.
#pragma once

#include "materials/laws.hpp"
#include "materials/shock_hugoniot.hpp"
#include "materials/tait.hpp"

namespace kerf {

KERF_DEFINE_LAW_SET(EquationOfStateSet, EquationOfState, KERF_EQUATIONS_OF_STATE)

// Matter with an equation of state.
template <class T>
struct BarotropicMatter : RestState<T>, EquationOfStateSet<T> {
  EquationOfState equation_of_state = EquationOfState::tait;
  bool cavitates = false;  // opens instead of bearing tension

  template <class Other>
  KERF_FUNCTION static BarotropicMatter from(const BarotropicMatter<Other>& other) {
    BarotropicMatter matter;
    static_cast<EquationOfStateSet<T>&>(matter) = EquationOfStateSet<T>::from(other);
    matter.equation_of_state = other.equation_of_state;
    matter.cavitates = other.cavitates;
    matter.density = static_cast<T>(other.density);
    matter.sound_speed = static_cast<T>(other.sound_speed);
    return matter;
  }
};

struct IsWeaklyCompressible {
  template <class Law>
  KERF_FUNCTION bool operator()(const Law&) const {
    return Law::is_weakly_compressible;
  }
};
template <class T>
KERF_FUNCTION bool is_weakly_compressible(const EquationOfStateSet<T>& laws, EquationOfState law) {
  return EquationOfStateSet<T>::visit(laws, law, IsWeaklyCompressible{});
}
template <class T>
KERF_FUNCTION bool is_weakly_compressible(const BarotropicMatter<T>& matter) {
  return is_weakly_compressible(matter, matter.equation_of_state);
}

template <class T, class Number>
KERF_FUNCTION bool is_opened(const BarotropicMatter<T>& matter, Number compression) {
  return matter.cavitates && compression < Number(0);
}

// Pressure by the law, whether the matter opens or not, Pa.
template <class T>
KERF_FUNCTION T unopened_pressure_at(const BarotropicMatter<T>& matter, T compression) {
  return EquationOfStateSet<T>::visit(matter, matter.equation_of_state, [&](const auto& law) {
    return law.pressure(matter, compression);
  });
}
// Pressure, Pa.
template <class T>
KERF_FUNCTION T pressure_at(const BarotropicMatter<T>& matter, T compression) {
  return is_opened(matter, compression) ? T(0) : unopened_pressure_at(matter, compression);
}

// Sound speed at this density, m/s.
template <class T>
KERF_FUNCTION T sound_speed_at(const BarotropicMatter<T>& matter, T compression) {
  return EquationOfStateSet<T>::visit(matter, matter.equation_of_state, [&](const auto& law) {
    return law.sound_speed(matter, compression);
  });
}

// Compression at a pressure, 1; 0 where that is not positive. Newton's method from the compression
// of a constant modulus, which is too large as the modulus grows with the compression: p(x) is
// convex, so that each step comes closer from above.
template <class T>
T compression_at(const BarotropicMatter<T>& matter, T pressure) {
  if (!(pressure > T(0))) return T(0);
  T x = pressure / (matter.density * matter.sound_speed * matter.sound_speed);
  for (int k = 0; k < 8; ++k) {
    const T c = sound_speed_at(matter, x);
    x -= (pressure_at(matter, x) - pressure) / (matter.density * c * c);
  }
  return x;
}

// Sound speed of the impedance between two particles, m/s. In weakly compressible matter that at
// rest does, and costs no power per pair.
template <class T>
KERF_FUNCTION T impedance_speed_at(const BarotropicMatter<T>& matter, T compression) {
  return is_weakly_compressible(matter) ? matter.sound_speed : sound_speed_at(matter, compression);
}

// Energy stored by the law, whether the matter opens or not, J/kg.
template <class T>
KERF_FUNCTION double unopened_energy_at(const BarotropicMatter<T>& matter, double compression) {
  return EquationOfStateSet<T>::visit(matter, matter.equation_of_state, [&](const auto& law) {
    return law.energy(matter, compression);
  });
}
// Stored energy, J/kg.
template <class T>
KERF_FUNCTION double energy_at(const BarotropicMatter<T>& matter, double compression) {
  return is_opened(matter, compression) ? 0.0 : unopened_energy_at(matter, compression);
}

// Whether no pressure reaches this density.
template <class T>
KERF_FUNCTION bool is_too_dense(const BarotropicMatter<T>& matter, T compression) {
  return EquationOfStateSet<T>::visit(matter, matter.equation_of_state,
                                      [&](const auto& law) { return law.is_beyond(compression); });
}

}  // namespace kerf
