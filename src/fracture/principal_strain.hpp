// SPDX-License-Identifier: Apache-2.0
// Largest principal strain. A bond breaks when
// - it is itself longer than the limit, ln(lambda) > limit, which no bond is in a uniform strain
// below
//   it; at the tip of a crack such bonds go first. Or
// - the largest principal strain at its place (the mean of its ends) passes the limit, and the bond
//   runs across the crack that opens there: it has at least a quarter of that strain (within 60
//   degrees of the axis, for a uniaxial strain) and takes its part of it (bond_strain.hpp). So the
//   slanting bonds go along with the straight ones and do not bridge the crack.
// The limit is in Hencky's measure, because strains of successive stretches add up and it is what a
// tensile test calls true strain.
#pragma once

#include "fracture/bond_strain.hpp"
#include "materials/finite_strain.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

struct PrincipalStrain {
  // lambda^2 - 1 of the largest principal stretch.
  template <int D, class T>
  KERF_FUNCTION static T prepare(const SolidMedium<T>& solid, const SymmetricTensor<D, T>& green) {
    if (!(solid.failure_strain > T(0))) return T(0);
    const Vector<3, T> values = principal_values(green);
    T largest = values[0] > values[1] ? values[0] : values[1];
    largest = largest > values[2] ? largest : values[2];
    return T(2) * largest;
  }

  // Whether it is sure not to pass, by a bound that costs a tenth.
  template <int D, class T>
  KERF_FUNCTION static bool stays_below(const SolidMedium<T>& solid,
                                        const SymmetricTensor<D, T>& green) {
    return !passes(T(2) * possible_values(green).most + T(1e-5), solid);
  }

  template <class T>
  KERF_FUNCTION static bool passes(T prepared, const SolidMedium<T>& solid) {
    return is_above(prepared, solid.failure_strain);
  }

  template <class T>
  KERF_FUNCTION static bool breaks(const BondStrain<T>& bond, const SolidMedium<T>& solid) {
    if (is_above(bond.own, solid.failure_strain)) return true;
    return passes(bond.prepared, solid) && bond.mean > T(0.25) * bond.prepared && bond.is_opening();
  }
};

}  // namespace kerf
