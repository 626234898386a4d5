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
#include "materials/finite_strain.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

struct StrainEnergy {
  // sqrt(2 psi_+ / M): the uniaxial strain that stores as much.
  template <int D, class T>
  KERF_FUNCTION static T prepare(const SolidMedium<T>& solid, const SymmetricTensor<D, T>& green) {
    if (!(solid.failure_strain > T(0))) return T(0);
    const Vector<3, T> values = principal_values(green);
    T sum = T(0), square = T(0);
    for (int a = 0; a < 3; ++a) {
      const T strain = T(0.5) * std::log1p(T(2) * values[a]);
      sum += strain;
      if (strain > T(0)) square += strain * strain;
    }
    const T g = solid.shear_modulus, lame = solid.bulk_modulus - T(2) / T(3) * g;
    const T twice = (sum > T(0) ? lame * sum * sum : T(0)) + T(2) * g * square;
    return twice > T(0) ? std::sqrt(twice / (lame + T(2) * g)) : T(0);
  }

  template <class T>
  KERF_FUNCTION static bool passes(T prepared, const SolidMedium<T>& solid) {
    return solid.failure_strain > T(0) && prepared > solid.failure_strain;
  }

  template <class T>
  KERF_FUNCTION static bool breaks(const BondStrain<T>& bond, const SolidMedium<T>& solid) {
    return is_above(bond.own, solid.failure_strain) ||
           (passes(bond.prepared, solid) && bond.mean > T(0.5) * solid.failure_strain &&
            bond.is_opening());
  }
};

}  // namespace kerf
