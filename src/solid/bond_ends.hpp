// SPDX-License-Identifier: Apache-2.0
// What a bond is, and how sums over bonds name them.
#pragma once

#include "core/mirror_planes.hpp"
#include "exec/exec.hpp"

namespace kerf {

// Every pair i, j of one piece that is closer than 2 h in the reference configuration is a bond. It
// stands in the lists of both, with one weight,
//   w_ij = f_ij V_i V_j |W'(R_ij)| / R_ij,   R_ij = |X_i - X_j|,
// of bond_weight.hpp, in which f_ij is the share of the bond that is whole: 1 (where the spacing
// jumps the s_ij of fit_levels.hpp), or 0 where it broke. A bond to a mirror image
// (core/mirror_planes.hpp) stands in the lists of both particles too, or once in that of a particle
// that is bound to its own image.
struct BondEnd {
  Index particle;     // j
  MirrorCode mirror;  // 0: j itself, else its image
};
// The same where it is known that j itself is meant: all that mirrors do is then left out.
struct DirectEnd {
  Index particle;
  static constexpr MirrorCode mirror = 0;
};

// A bond that a sum has come to, from particle i.
template <int D, class Real, class End>
struct ChosenBond {
  Index i;
  End j;
  Vector<D, Real> reference;  // X_j - X_i, m
  Real weight;                // w_ij
};

}  // namespace kerf
