// SPDX-License-Identifier: Apache-2.0
// Linear softening over a crack band (Bazant & Oh, Materiaux et Constructions 16 (1983) 155). A
// place is whole up to the strain e_0; from there on its stress falls, and is gone at e_f:
//   stress = (1 - D) x that of the whole solid,   1 - D = e_0 (e_f - k) / (k (e_f - e_0)).
// k is the largest there was of the strain of a tensile test that stores as much as tension does
// here: k = sqrt(2 psi_t / E). Then D takes, per volume,
//   int psi_t dD = E e_0 e_f / 2 x (k - e_0) / (e_f - e_0),
// whatever the elastic law, and a crack through a band w d wide takes  Gc = w d E e_0 e_f / 2. So
// the strain at which a crack starts is the material's, and so is what it takes as it runs; how
// far it opens meanwhile is left to the spacing.
//
// What is softened is the shear and the tension (Amor, Marigo & Maurini, J. Mech. Phys. Solids 57
// (2009) 1209): pressed together, a crack bears as the whole solid does.
#pragma once

#include <cmath>

#include "materials/elastic_law.hpp"

namespace kerf {

// Of the strain k: 1 - D.
template <class T>
KERF_FUNCTION T whole_share(const SolidMedium<T>& solid, T strain) {
  const T start = solid.softening_strain, end = solid.failure_strain;
  if (!(strain > start)) return T(1);
  if (!(strain < end)) return T(0);
  return start * (end - strain) / (strain * (end - start));
}

// What softening took so far per volume, J/m^3.
template <class T>
KERF_FUNCTION T softening_loss(const SolidMedium<T>& solid, T strain) {
  const T start = solid.softening_strain, end = solid.failure_strain;
  if (!(strain > start)) return T(0);
  const T part = strain < end ? (strain - start) / (end - start) : T(1);
  return T(0.5) * solid.young_modulus() * start * end * part;
}

// The moduli that are left where a share `whole` is: laws of elasticity are linear in them.
template <int D, class T>
KERF_FUNCTION SolidMedium<T> softened(const SolidMedium<T>& solid,
                                      const SymmetricTensor<D, T>& green, T whole) {
  SolidMedium<T> left = solid;
  left.shear_modulus *= whole;
  if (is_expanded(solid, green)) left.bulk_modulus *= whole;
  return left;
}

// sqrt(2 psi_t / E) of the whole solid; in double, because the energy is a small difference.
template <int D, class T>
KERF_FUNCTION T tensile_strain(const SolidMedium<T>& solid, const Matrix<D, T>& h) {
  auto medium = SolidMedium<double>::from(solid);
  const auto green = green_strain(Matrix<D, double>::from(h));
  if (!is_expanded(medium, green)) medium.bulk_modulus = 0.0;
  const double energy = energy_density(medium, green);
  return energy > 0.0 ? static_cast<T>(std::sqrt(2.0 * energy / double(solid.young_modulus())))
                      : T(0);
}

}  // namespace kerf
