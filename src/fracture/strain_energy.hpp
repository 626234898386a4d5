// SPDX-License-Identifier: Apache-2.0
// Energy release: a bond breaks where the energy that tension stores per volume,
//   psi_+ = (K - 2/3 G)/2 <tr e>^2 + G sum <e_k>^2,   <x> = max(x, 0),   e = ln(C)/2
// (Miehe, Hofacker & Welschinger, Comput. Methods Appl. Mech. Engrg. 199 (2010) 2765), is that of a
// crack over the crack band,  psi_+ w d = Gc  (crack_band.hpp), or, in terms of the failure strain
// that stands for it, M limit^2 / 2. Bonds break that are opening and take their part: a quarter of
// the strain at least (bond_strain.hpp). A bond whose own strain is above the limit breaks too: in
// a uniform strain its place passes no later.
#pragma once

#include <cmath>

#include "fracture/bond_strain.hpp"
#include "materials/damaged.hpp"

namespace kerf {

struct StrainEnergy {
  // sqrt(2 psi_+ / M): the uniaxial strain that stores as much.
  template <int D, class T>
  KERF_FUNCTION static T prepare(const SolidMedium<T>& solid, const SymmetricTensor<D, T>& green) {
    if (!(solid.failure_strain > T(0))) return T(0);
    const auto law = TensionLaw<T>::of(solid);
    const T twice = T(2) * law.energy(principal_values(green));
    return twice > T(0) ? std::sqrt(twice / (law.lame + T(2) * law.shear)) : T(0);
  }

  template <class T>
  KERF_FUNCTION static bool passes(T prepared, const SolidMedium<T>& solid) {
    return solid.fails_at(prepared);
  }

  template <class T>
  KERF_FUNCTION static bool breaks(const BondStrain<T>& bond, const SolidMedium<T>& solid) {
    return is_above(bond.own, solid.failure_strain) ||
           (passes(bond.prepared, solid) && bond.mean > T(0.5) * solid.failure_strain &&
            bond.is_opening());
  }
};

}  // namespace kerf
