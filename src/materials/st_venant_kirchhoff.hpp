// SPDX-License-Identifier: Apache-2.0
// St. Venant-Kirchhoff solid, Hooke's law between Green's strain and the second Piola-Kirchhoff
// stress:
//   psi = lambda/2 (tr E)^2 + G E : E,   S = lambda tr E + 2 G E,   lambda = K - 2 G / 3.
// It softens in compression and has no resistance left where a line is pressed to 1/sqrt(3) of its
// length: for large compression take the neo-Hookean law.
#pragma once

#include "materials/finite_strain.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

struct StVenantKirchhoff {
  template <class T>
  KERF_FUNCTION static T lame(const SolidMedium<T>& solid) {  // lambda, Pa
    return solid.bulk_modulus - T(2) / T(3) * solid.shear_modulus;
  }

  // psi, J/m^3.
  template <int D, class T>
  KERF_FUNCTION static T energy_density(const SolidMedium<T>& solid,
                                        const SymmetricTensor<D, T>& green) {
    const T change = trace(green);
    return T(0.5) * lame(solid) * change * change + solid.shear_modulus * contract(green, green);
  }

  // Second Piola-Kirchhoff stress, Pa.
  template <int D, class T>
  KERF_FUNCTION static SymmetricTensor<D, T> second_piola(const SolidMedium<T>& solid,
                                                          const SymmetricTensor<D, T>& green) {
    SymmetricTensor<D, T> stress = T(2) * solid.shear_modulus * green;
    const T change = lame(solid) * trace(green);
    for (int a = 0; a < 3; ++a) stress(a, a) += change;
    return stress;
  }
};

}  // namespace kerf
