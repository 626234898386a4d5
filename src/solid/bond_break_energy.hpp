// SPDX-License-Identifier: Apache-2.0
// BreakTerms sums the energy that is released when bonds break. The energy that a particle stores,
// and the power of its part of the forces, depend on its own bonds and on the motion of others, but
// not on the bonds of others. So only particles that lose bonds are counted: before the first
// breaks, and after the last.
#pragma once

#include "solid/update_plasticity.hpp"
#include "solid/update_softening.hpp"

namespace kerf {

// Returns the energy that particle i stores and what the current step dissipated of it, J.
template <int D, class P>
KERF_FUNCTION double stored_and_dissipated(const SolidView<D, P>& solid, Index i) {
  return energy_of(solid, i).total() + flow_work_of(solid, i) + softening_work_of(solid, i);
}

// Returns the power of the stress and hourglass control of particle i, without viscosity, W: that
// of its share w_ij [A_i R + mu_i (u_j - u_i)] of the force of a bond (solid/bond_force.hpp), which
// acts on i, and its opposite on j. The sum over all particles is the power of all forces.
template <int D, class P>
KERF_FUNCTION double elastic_power(const SolidView<D, P>& solid, Index i) {
  if (solid.detached[i]) return 0.0;
  const auto& own = solid.ends[i];
  double sum = 0.0;
  for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
    if (!solid.is_intact(i, k)) continue;
    const BondEnd j = solid.bond_end(i, k);
    auto force = Vector<D, typename P::Real>::zero();
    add_bond_force(force, solid.bond_geometry(i, k, j), own.traction, own.hourglass);
    sum -= double(dot(force, solid.velocity_bond(i, j)));
  }
  return sum;
}

// The state of a particle before its first bond breaks in this step.
struct BondBreakEnergy {
  double energy, power;  // J, W (2D: per m)
  Index bonds;
  std::uint8_t detached, is_recorded;
};

template <int D, class P>
struct BreakRecords {
  BondBreakEnergy* of = nullptr;  // per particle; null: not recorded

  // Must be called before a bond of particle i breaks, or it becomes detached.
  KERF_FUNCTION void record(const SolidView<D, P>& solid, Index i) const {
    if (of == nullptr || of[i].is_recorded) return;
    of[i] = {stored_and_dissipated(solid, i), elastic_power(solid, i), solid.intact_bonds(i),
             solid.detached[i], 1};
  }
};

// Sums the broken bonds, counted from both ends; the particles that became detached; the released
// energy, J; the gain of power, W. It clears the records.
template <int D, class P>
struct BreakTerms {
  SolidView<D, P> solid;
  BreakRecords<D, P> records;

  KERF_FUNCTION void add(Index i, Terms<4>& sum) const {
    auto& before = records.of[i];
    if (!before.is_recorded) return;
    before.is_recorded = 0;
    sum.value[0] += before.bonds - solid.intact_bonds(i);
    sum.value[1] += solid.detached[i] - before.detached;
    sum.value[2] += before.energy - stored_and_dissipated(solid, i);
    sum.value[3] += elastic_power(solid, i) - before.power;
  }
};

}  // namespace kerf
