// SPDX-License-Identifier: Apache-2.0
// Correct computes the gradient correction of a particle when its bonds have changed:
//   B_i = (sum_j V_j f_ij (X_j - X_i) (x) grad_0 W_ij)^-1 = V_i (sum_j w_ij R (x) R)^-1,
// after which the gradient of any linear field is exact, beside free surfaces and cracks too (Bonet
// & Lok, Comput. Methods Appl. Mech. Engrg. 180 (1999) 97). A particle that has no valid B is
// detached.
#pragma once

#include "solid/bond_break_energy.hpp"

namespace kerf {

// D bonds determine a deformation gradient, and then every motion is a deformation: noise cannot be
// distinguished from strain. With one more the hourglass control resists it.
template <int D>
inline constexpr Index least_bonds = D + 1;
// Least eigenvalue of the moment, which is near 1 inside, 0.4 on a face and 0.2 in the corner of a
// cube along the lattice; the corner of a square at 15 degrees to it, which holds, has 0.07.
inline constexpr double least_moment = 0.05;

template <int D, class P>
struct Correct {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    if (!solid.changed[i]) return;
    solid.changed[i] = 0;
    solid.has_broken_bonds[i] = 1;
    if (solid.detached[i]) return clear_correction(i);
    // In double: the sums of solid/deformation_gradient.hpp are rounded in another order, and must
    // not depend on its rounding here.
    const double volume = solid.medium(i).reference_volume();
    auto moment = Matrix<D, double>::zero();
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      if (!solid.is_intact(i, k)) continue;
      const BondEnd j = solid.bond_end(i, k);
      const double weight = solid.weight(i, k, j, solid.reference_bond(i, j));
      const auto bond = solid.template reference_bond<double>(i, j);
      add_outer(moment, (weight / volume) * bond, bond);
    }
    const Index intact = solid.intact_bonds(i);
    solid.has_broken_bonds[i] = intact < solid.bonds.count[i];
    auto correction = identity<D, double>();
    if (intact < least_bonds<D> || !divide(correction, moment, least_moment)) {
      solid.detached[i] = 1;
      return clear_correction(i);
    }
    solid.correction[i] = Matrix<D, Real>::from((1.0 / volume) * correction);
  }

 private:
  KERF_FUNCTION void clear_correction(Index i) const {
    solid.correction[i] = Matrix<D, Real>::zero();
    solid.changed[i] = solid.intact_bonds(i) > 0;
  }
};

// Breaks the bonds of `chosen` particles, on the side of this particle.
template <int D, class P>
struct BreakAllBonds {
  SolidView<D, P> solid;
  const std::uint8_t* chosen;  // 1: all its bonds break
  BreakRecords<D, P> records = {};

  KERF_FUNCTION void operator()(Index i) const {
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      if (!solid.is_intact(i, k)) continue;
      if (!chosen[i] && !chosen[solid.bond_end(i, k).particle]) continue;
      records.record(solid, i);
      solid.break_bond(i, k);
      solid.changed[i] = 1;
    }
  }
};

}  // namespace kerf
