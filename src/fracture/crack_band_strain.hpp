// SPDX-License-Identifier: Apache-2.0
// The end of softening (softening.hpp). A bond breaks
// - once it has opened by e_f of its length: at a crack one bond has it all, the places beside it
//   about half. Or
// - where the tensile strain of its place has passed e_f, so that nothing is left to bear, if it is
//   opening and takes its part, a quarter of that strain at least (bond_strain.hpp).
#pragma once

#include "fracture/bond_strain.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

struct CrackBandStrain {
  template <class T>
  KERF_FUNCTION static bool passes(T prepared, const SolidMedium<T>& solid) {
    return solid.fails_at(prepared);
  }

  template <class T>
  KERF_FUNCTION static bool breaks(const BondStrain<T>& bond, const SolidMedium<T>& solid) {
    const T end = solid.failure_strain;
    if (!(end > T(0))) return false;
    return bond.own > end * (T(2) + end) ||
           (passes(bond.prepared, solid) && bond.mean > T(0.5) * end && bond.is_opening());
  }
};

}  // namespace kerf
