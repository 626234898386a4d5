// SPDX-License-Identifier: Apache-2.0
// Softening over a crack band is linear (Bazant & Oh, Materiaux et Constructions 16 (1983) 155). A
// particle is undamaged up to the strain e_0; from there on its stress falls, to zero at e_f:
//   stress = (1 - D) x that of the undamaged solid,   1 - D = e_0 (e_f - k) / (k (e_f - e_0)).
// k is the largest value so far of the strain of a tensile test that stores as much as tension does
// in the particle: k = sqrt(2 psi_t / E). Then D dissipates, per volume,
//   int psi_t dD = E e_0 e_f / 2 x (k - e_0) / (e_f - e_0),
// whatever the elastic law, and a crack through a band w d wide takes  Gc = w d E e_0 e_f / 2. So
// the strain at which a crack starts is the material's, and so is the energy that it takes as it
// runs; its opening meanwhile depends on the spacing.
//
// Shear and tension soften (Amor, Marigo & Maurini, J. Mech. Phys. Solids 57 (2009) 1209): under
// compression a crack bears as the undamaged solid does.
#pragma once

#include "fracture/breakable_solid.hpp"

namespace kerf {

// 1 - D at the strain k.
template <class T>
KERF_FUNCTION T undamaged_share(const BreakableSolid<T>& solid, T strain) {
  const T start = solid.softening_strain, end = solid.failure_strain;
  if (!(strain > start)) return T(1);
  if (!(strain < end)) return T(0);
  return start * (end - strain) / (strain * (end - start));
}

// Energy that softening has dissipated so far, J/m^3.
template <class T>
KERF_FUNCTION T softening_loss(const BreakableSolid<T>& solid, T strain) {
  const T start = solid.softening_strain, end = solid.failure_strain;
  if (!(strain > start)) return T(0);
  const T part = strain < end ? (strain - start) / (end - start) : T(1);
  return T(0.5) * solid.young_modulus() * start * end * part;
}

// The solid with the moduli that are left at the share `undamaged` = 1 - D: elastic laws are linear
// in them.
template <int D, class T>
KERF_FUNCTION ElasticSolid<T> softened(const ElasticSolid<T>& solid,
                                       const SymmetricTensor<D, T>& green, T undamaged) {
  ElasticSolid<T> left = solid;
  left.shear_modulus *= undamaged;
  if (is_expanded(solid, green)) left.bulk_modulus *= undamaged;
  return left;
}

}  // namespace kerf
