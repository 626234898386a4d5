// SPDX-License-Identifier: Apache-2.0
// The types of this file name the other end of a bond in sums over bonds.
#pragma once

#include "core/mirror_planes.hpp"
#include "parallel/loops.hpp"
#include "solid/bond_terms.hpp"

namespace kerf {

// Every pair i, j of one piece that is closer than 2 h in the reference configuration is a bond. It
// stands in the lists of both, with one weight,
//   w_ij = f_ij V_i V_j |W'(R_ij)| / R_ij,   R_ij = |X_i - X_j|,
// of bond_weight.hpp, in which f_ij is 1 for an intact bond (where the spacing jumps the s_ij of
// gradient_correction_levels.hpp) and 0 for a broken one. A bond to a mirror image
// (core/mirror_planes.hpp) stands in the lists of both particles too, or once in that of a particle
// that is bound to its own image.
struct BondEnd {
  Index particle;     // j
  MirrorCode mirror;  // 0: j itself, else its image
};
// The other end of a bond that is known to lead to j itself, so that no code for mirrors is needed.
struct DirectEnd {
  Index particle;
  static constexpr MirrorCode mirror = 0;
};

// The current bond of a sum over the bonds of particle i.
template <int D, class Real, class End>
struct ChosenBond {
  Index i;
  End j;
  BondGeometry<D, Real> bond;
};

}  // namespace kerf
