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
    return factor != nullptr && is_one_volume(particles, pair) ? between(particles, pair.i, pair.j)
                                                               : Real(1);
  }
  // The same for two particles of one volume.
  KERF_FUNCTION Real between(const ParticleView<D, P>& particles, Index i, Index j) const {
    if (!particles.has(i, flag::fitted) || !particles.has(j, flag::fitted)) return Real(1);
    const Index bond =
        bond_between(bonds, solid_index_of_id[particles.id[i]], solid_index_of_id[particles.id[j]]);
    return bond == no_bond ? Real(1) : factor[bond];
  }
};

}  // namespace kerf
