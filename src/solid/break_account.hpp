// SPDX-License-Identifier: Apache-2.0
// What it sets free that bonds break. What a particle stores, and the power of its part of the
// forces, hang on its own bonds and on the motion of others, but on nothing that others lose. So
// only those that lose bonds are looked at: before the first goes, and after the last.
#pragma once

#include "solid/keep_flow.hpp"
#include "solid/keep_softening.hpp"

namespace kerf {

// What is stored by particle i, and what the step in hand took from that, J.
template <int D, class P>
KERF_FUNCTION double held_energy(const SolidView<D, P>& solid, Index i) {
  return energy_of(solid, i).total() + flow_work_of(solid, i) + softening_work_of(solid, i);
}

// Power of the stress and hourglass control of particle i, without viscosity, W. Of its share
// w_ij [A_i R + mu_i (u_j - u_i)] of the force of a bond (bond_force.hpp), which acts on i, and
// backwards on j. Summed over all particles it is the power of all forces.
template <int D, class P>
KERF_FUNCTION double elastic_power(const SolidView<D, P>& solid, Index i) {
  if (solid.loose[i]) return 0.0;
  const auto& own = solid.ends[i];
  double sum = 0.0;
  for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
    if (!solid.is_whole(i, k)) continue;
    const BondEnd j = solid.bond_end(i, k);
    const auto bond = solid.reference_bond(i, j);
    const auto share = own.traction * bond + own.hourglass * solid.displacement_bond(i, j);
    sum -= double(solid.weight(i, k, j, bond)) * double(dot(share, solid.velocity_bond(i, j)));
  }
  return sum;
}

// Of a particle, before its bonds broke.
struct BreakAccount {
  double held, power;  // J, W (2D: per m)
  Index bonds;
  std::uint8_t loose, is_open;
};

template <int D, class P>
struct BreakAccounts {
  BreakAccount* of = nullptr;  // per particle; null: nobody asks

  // To be called before a bond of particle i breaks, or it comes loose.
  KERF_FUNCTION void open(const SolidView<D, P>& solid, Index i) const {
    if (of == nullptr || of[i].is_open) return;
    of[i] = {held_energy(solid, i), elastic_power(solid, i), solid.whole_bonds(i), solid.loose[i],
             1};
  }
};

// Bonds that broke, counted from both ends; particles that came loose; J set free; W gained. Closes
// the accounts.
template <int D, class P>
struct BreakTerms {
  SolidView<D, P> solid;
  BreakAccounts<D, P> accounts;

  KERF_FUNCTION void add(Index i, Terms<4>& sum) const {
    auto& before = accounts.of[i];
    if (!before.is_open) return;
    before.is_open = 0;
    sum.value[0] += before.bonds - solid.whole_bonds(i);
    sum.value[1] += solid.loose[i] - before.loose;
    sum.value[2] += before.held - held_energy(solid, i);
    sum.value[3] += elastic_power(solid, i) - before.power;
  }
};

}  // namespace kerf
