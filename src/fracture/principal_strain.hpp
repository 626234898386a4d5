// SPDX-License-Identifier: Apache-2.0
// Largest principal strain, as a test of each bond: the logarithmic (Hencky) strain along the bond,
// ln lambda, passes the limit. Over bonds of many directions the largest such strain is the largest
// principal one, and the bonds that break are those that point that way: the crack runs across
// them. Hencky's measure, because strains of successive stretches add up and what a tensile test
// calls true strain is the same number.
#pragma once

#include <cmath>

#include "fracture/bond_strain.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

struct PrincipalStrain {
  template <int D, class T>
  KERF_FUNCTION static T prepare(const SolidMedium<T>&, const SymmetricTensor<D, T>&) {
    return T(0);
  }

  template <class T>
  KERF_FUNCTION static bool breaks(const BondStrain<T>& bond, const SolidMedium<T>& solid) {
    const T limit = solid.failure_strain;
    // exp(2 limit) - 1 > 2 limit: most bonds need no exponential.
    if (!(limit > T(0)) || !(bond.own > T(2) * limit)) return false;
    const T stretch = std::expm1(T(2) * limit);
    return bond.own > stretch && bond.mean > stretch;
  }
};

}  // namespace kerf
