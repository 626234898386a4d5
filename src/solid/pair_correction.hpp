// SPDX-License-Identifier: Apache-2.0
// PairCorrection is the factor s_ij of the pressure force of a pair of a nearly incompressible
// solid where the spacing jumps: that of its bond (solid/gradient_correction_levels.hpp), intact or
// broken.
#pragma once

#include "pairs/pair.hpp"
#include "solid/bond_table.hpp"

namespace kerf {

template <int D, class P>
struct PairCorrection {
  using Real = typename P::Real;
  const Real* factor = nullptr;  // per bond; null: 1
  const Index* solid_index_of_id = nullptr;
  BondTable<D> bonds{};

  KERF_FUNCTION Real operator()(const ParticleView<D, P>& particles, const Pair<D, P>& pair) const {
    if (factor == nullptr || !particles.has(pair.i, flag::fitted) ||
        !particles.has(pair.j, flag::fitted) || !is_one_volume(particles, pair))
      return Real(1);
    return between(solid_index_of_id[particles.id[pair.i]], solid_index_of_id[particles.id[pair.j]],
                   pair.mirror);
  }
  // The same for two particles of one volume, by their numbers among those of solids, or for the
  // image of the second; no_bond: it has no factors.
  KERF_FUNCTION Real between(Index i, Index j, MirrorCode mirror = 0) const {
    if (i == no_bond || j == no_bond) return Real(1);
    const Index bond = bond_between(bonds, i, j | mirror);
    return bond == no_bond ? Real(1) : factor[bond];
  }
};

}  // namespace kerf
