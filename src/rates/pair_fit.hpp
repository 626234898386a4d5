// SPDX-License-Identifier: Apache-2.0
// The factor s_ij with which a pair of a nearly incompressible solid presses where the spacing
// jumps: that of its bond (solid/fit_levels.hpp), whether the bond still holds or not.
#pragma once

#include "rates/pair.hpp"
#include "solid/bond_table.hpp"

namespace kerf {

template <int D, class P>
struct PairFit {
  using Real = typename P::Real;
  const Real* factor = nullptr;  // per bond; null: 1
  const Index* number_of_id = nullptr;
  BondTable<D> bonds{};

  KERF_FUNCTION Real operator()(const ParticleView<D, P>& particles, const Pair<D, P>& pair) const {
    if (factor == nullptr || !particles.has(pair.i, flag::fitted) ||
        !particles.has(pair.j, flag::fitted) || !is_one_volume(particles, pair))
      return Real(1);
    const Index bond =
        bond_between(bonds, number_of_id[particles.id[pair.i]], number_of_id[particles.id[pair.j]]);
    return bond == no_bond ? Real(1) : factor[bond];
  }
};

}  // namespace kerf
