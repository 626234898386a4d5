// SPDX-License-Identifier: Apache-2.0
// The elastic laws of the total Lagrangian solid, chosen per medium while the program runs. A law
// is a function of Green's strain, so a rotation changes nothing whatever the law.
#pragma once

#include "materials/neo_hookean.hpp"
#include "materials/st_venant_kirchhoff.hpp"

namespace kerf {

// Stored energy per reference volume, J/m^3.
template <int D, class T>
KERF_FUNCTION T energy_density(const SolidMedium<T>& solid, const SymmetricTensor<D, T>& green) {
  switch (solid.law) {
    case ElasticLaw::neo_hookean:
      return NeoHookean::energy_density(solid, green);
    case ElasticLaw::st_venant_kirchhoff:
      return StVenantKirchhoff::energy_density(solid, green);
  }
  return T(0);
}

// Whether the part of the law that K scales is in tension.
template <int D, class T>
KERF_FUNCTION bool is_expanded(const SolidMedium<T>& solid, const SymmetricTensor<D, T>& green) {
  switch (solid.law) {
    case ElasticLaw::neo_hookean:
      return volume_square_less_one(green) > T(0);
    case ElasticLaw::st_venant_kirchhoff:
      return trace(green) > T(0);
  }
  return false;
}

// Second Piola-Kirchhoff stress S = dpsi/dE, Pa.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> second_piola(const SolidMedium<T>& solid,
                                                 const SymmetricTensor<D, T>& green) {
  switch (solid.law) {
    case ElasticLaw::neo_hookean:
      return NeoHookean::second_piola(solid, green);
    case ElasticLaw::st_venant_kirchhoff:
      return StVenantKirchhoff::second_piola(solid, green);
  }
  return SymmetricTensor<D, T>::zero();
}

// First Piola-Kirchhoff stress P = F S at the displacement gradient H = F - 1, Pa.
template <int D, class T>
KERF_FUNCTION Matrix<D, T> first_piola(const SymmetricTensor<D, T>& second, const Matrix<D, T>& h) {
  const Matrix<D, T> stress = in_plane(second);
  return stress + h * stress;
}
// That of an elastic solid, dpsi/dF.
template <int D, class T>
KERF_FUNCTION Matrix<D, T> piola(const SolidMedium<T>& solid, const Matrix<D, T>& h) {
  return first_piola(second_piola(solid, green_strain(h)), h);
}

// Cauchy stress F S F^T / J, Pa, with its component out of the plane.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> cauchy(const SymmetricTensor<D, T>& second,
                                           const Matrix<D, T>& h) {
  const T volume = std::sqrt(T(1) + volume_square_less_one(green_strain(h)));  // J
  const Matrix<D, T> first = first_piola(second, h);
  auto stress = SymmetricTensor<D, T>::zero();
  stress(2, 2) = second(2, 2) / volume;
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) {
      T sum = first(a, b);  // P F^T = P + P H^T
      for (int c = 0; c < D; ++c) sum += first(a, c) * h(b, c);
      stress(a, b) = sum / volume;
    }
  return stress;
}
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> cauchy(const SolidMedium<T>& solid, const Matrix<D, T>& h) {
  return cauchy(second_piola(solid, green_strain(h)), h);
}

}  // namespace kerf
