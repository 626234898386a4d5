// SPDX-License-Identifier: Apache-2.0
// The criterion grady_kipp (grady_kipp.hpp): a bond breaks when the damage of one of its ends is
// whole and it is opening (bond_strain.hpp). Until then damage takes tension off the particle
// (materials/damaged.hpp); what is whole bears none, and without its bonds it can part.
#pragma once

#include "fracture/bond_strain.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

struct DamagedBond {
  // So that one end suffices for the mean of both to be 1.
  template <class T>
  KERF_FUNCTION static T prepare(T damage) {
    return damage < T(1) ? T(0) : T(2);
  }
  template <class T>
  KERF_FUNCTION static bool passes(T prepared) {
    return !(prepared < T(1));
  }
  template <class T>
  KERF_FUNCTION static bool breaks(const BondStrain<T>& bond) {
    return passes(bond.prepared) && bond.is_opening();
  }
};

}  // namespace kerf
