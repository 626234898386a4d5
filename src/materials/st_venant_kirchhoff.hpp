// SPDX-License-Identifier: Apache-2.0
// The St. Venant-Kirchhoff solid obeys Hooke's law between Green's strain and the second
// Piola-Kirchhoff stress:
//   psi = lambda/2 (tr E)^2 + G E : E,   S = lambda tr E + 2 G E,   lambda = K - 2 G / 3.
// It softens in compression and has no resistance left where a line is pressed to 1/sqrt(3) of its
// length: the neo-Hookean law suits large compression better.
#pragma once

#include <string_view>

#include "materials/elastic_moduli.hpp"
#include "materials/finite_strain.hpp"

namespace kerf {

template <class T>
struct StVenantKirchhoff {
  static constexpr std::string_view sentence =
      "Hooke's law between Green's strain and the second Piola-Kirchhoff stress, for large "
      "rotations and small strains";

  // psi, J/m^3.
  template <int D>
  KERF_FUNCTION T energy_density(const ElasticModuli<T>& moduli,
                                 const SymmetricTensor<D, T>& green) const {
    const T change = trace(green);
    return T(0.5) * moduli.lame() * change * change + moduli.shear_modulus * contract(green, green);
  }

  // Second Piola-Kirchhoff stress, Pa.
  template <int D>
  KERF_FUNCTION SymmetricTensor<D, T> second_piola(const ElasticModuli<T>& moduli,
                                                   const SymmetricTensor<D, T>& green) const {
    SymmetricTensor<D, T> stress = T(2) * moduli.shear_modulus * green;
    const T change = moduli.lame() * trace(green);
    for (int a = 0; a < 3; ++a) stress(a, a) += change;
    return stress;
  }

  // Whether the part of the energy that lambda scales is one of expansion.
  template <int D>
  KERF_FUNCTION bool is_expanded(const SymmetricTensor<D, T>& green) const {
    return trace(green) > T(0);
  }

  template <class Other>
  KERF_FUNCTION static StVenantKirchhoff from(const StVenantKirchhoff<Other>&) {
    return {};
  }
  bool operator==(const StVenantKirchhoff&) const = default;
};

}  // namespace kerf
