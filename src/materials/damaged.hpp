// SPDX-License-Identifier: Apache-2.0
// Damage D takes a part of the tension off an elastic solid:
//   psi = psi_elastic - D psi_+,   psi_+ = (K - 2/3 G)/2 <tr e>^2 + G sum <e_k>^2,  e = ln(C)/2,
// psi_+ the energy that tension stores (Miehe, Hofacker & Welschinger, Comput. Methods Appl. Mech.
// Engrg. 199 (2010) 2765), <x> = max(x, 0). Damage takes nothing off compression. The stress is the
// slope of psi, so that the energy that the damage of a step dissipates is psi_+ dD.
#pragma once

#include <cmath>

#include "core/principal_frame.hpp"
#include "materials/elastic_law.hpp"

namespace kerf {

template <class T>
struct TensionLaw {
  T lame, shear;  // K - 2/3 G, G

  template <class Other>
  KERF_FUNCTION static TensionLaw of(const ElasticModuli<Other>& solid) {
    return {T(solid.bulk_modulus) - T(2) / T(3) * T(solid.shear_modulus), T(solid.shear_modulus)};
  }

  // psi_+ of the principal values of Green's strain, J/m^3.
  KERF_FUNCTION T energy(const Vector<3, T>& green) const {
    T sum = T(0), square = T(0);
    for (int k = 0; k < 3; ++k) {
      const T strain = hencky(green[k]);
      sum += strain;
      if (strain > T(0)) square += strain * strain;
    }
    return T(0.5) * (sum > T(0) ? lame * sum * sum : T(0)) + shear * square;
  }

  // d psi_+ / dE, Pa.
  template <int D>
  KERF_FUNCTION SymmetricTensor<D, T> stress(const SymmetricTensor<D, T>& green) const {
    const auto frame = PrincipalFrame<D, T>::of(green);
    const T sum = hencky(frame.value[0]) + hencky(frame.value[1]) + hencky(frame.value[2]);
    Vector<3, T> stress;
    for (int k = 0; k < 3; ++k) {
      const T strain = hencky(frame.value[k]);
      const T kirchhoff =
          (sum > T(0) ? lame * sum : T(0)) + (strain > T(0) ? T(2) * shear * strain : T(0));
      stress[k] = kirchhoff / (T(1) + T(2) * frame.value[k]);
    }
    return frame.tensor(stress);
  }

  // The local scalar strain of Benz & Asphaug (1995): the largest principal stress without damage
  // over Young's modulus.
  KERF_FUNCTION T scalar_strain(const Vector<3, T>& green) const {
    T sum = T(0), largest = hencky(green[0]);
    for (int k = 0; k < 3; ++k) {
      const T strain = hencky(green[k]);
      sum += strain;
      largest = strain > largest ? strain : largest;
    }
    const T young = shear * (T(3) * lame + T(2) * shear) / (lame + shear);
    return (lame * sum + T(2) * shear * largest) / young;
  }

 private:
  KERF_FUNCTION static T hencky(T green) { return T(0.5) * std::log1p(T(2) * green); }
};

// Second Piola-Kirchhoff stress, Pa.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> second_piola(const ElasticSolid<T>& solid,
                                                 const SymmetricTensor<D, T>& green, T damage) {
  auto stress = second_piola(solid, green);
  if (damage > T(0)) stress += (-damage) * TensionLaw<T>::of(solid).stress(green);
  return stress;
}

// psi, J/m^3.
template <int D, class T>
KERF_FUNCTION T energy_density(const ElasticSolid<T>& solid, const SymmetricTensor<D, T>& green,
                               T damage) {
  const T elastic = energy_density(solid, green);
  if (!(damage > T(0))) return elastic;
  return elastic - damage * TensionLaw<T>::of(solid).energy(principal_values(green));
}

}  // namespace kerf
