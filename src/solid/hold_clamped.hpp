// SPDX-License-Identifier: Apache-2.0
// HoldClamped marks the particles that a clamp holds: those of fixed or prescribed motion, and
// those with a bond to one. At the edge of a clamp the strain of an elastic solid has no limit (M.
// L. Williams, J. Appl. Mech. 19 (1952) 526), so that it grows with refinement, and no strength of
// the material can be judged there. A grip holds without breaking: the material of held particles
// neither softens nor grows flaws nor fails by plastic flow, and their bonds do not break by a
// criterion. Fracture begins beyond a support radius from the clamp
// (docs/theory/total_lagrangian.md).
#pragma once

#include "solid/solid_fields.hpp"

namespace kerf {

template <int D, class P>
struct HoldClamped {
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    bool held = solid.medium(i).constrained;
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i) && !held; ++k)
      held = solid.medium(solid.bond_end(i, k).particle).constrained;
    solid.held[i] = held;
  }
};

}  // namespace kerf
