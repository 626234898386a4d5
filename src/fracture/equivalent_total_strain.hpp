// SPDX-License-Identifier: Apache-2.0
// Equivalent strain of the deformation gradient: sqrt(2/3 e' : e') of the deviator e' of Hencky's
// strain e = ln(C)/2, the finite-strain form of the criterion of Shinohara et al. (2004), section
// 2.3. It does not know tension from compression: of the bonds at a place that passes the limit
// those break that are stretched and take their part (bond_strain.hpp). A bond whose own strain is
// above 3/2 of the limit breaks too, the strain at which the equivalent strain of a uniaxial
// strain, 2/3 e, passes it; this holds the tip of a crack together no longer than a uniform field,
// and is the only limit there is to hydrostatic tension.
#pragma once

#include <cmath>

#include "fracture/bond_strain.hpp"
#include "materials/finite_strain.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

struct EquivalentTotalStrain {
  template <int D, class T>
  KERF_FUNCTION static T prepare(const SolidMedium<T>& solid, const SymmetricTensor<D, T>& green) {
    if (!(solid.failure_strain > T(0))) return T(0);
    Vector<3, T> strain = principal_values(green);
    T mean = T(0), square = T(0);
    for (int a = 0; a < 3; ++a) {
      strain[a] = T(0.5) * std::log1p(T(2) * strain[a]);
      mean += strain[a] / T(3);
    }
    for (int a = 0; a < 3; ++a) square += (strain[a] - mean) * (strain[a] - mean);
    return std::sqrt(T(2) / T(3) * square);
  }

  template <class T>
  KERF_FUNCTION static bool passes(T prepared, const SolidMedium<T>& solid) {
    return solid.fails_at(prepared);
  }

  template <class T>
  KERF_FUNCTION static bool breaks(const BondStrain<T>& bond, const SolidMedium<T>& solid) {
    return is_above(bond.own, T(1.5) * solid.failure_strain) ||
           (passes(bond.prepared, solid) && bond.is_opening());
  }
};

}  // namespace kerf
