// SPDX-License-Identifier: Apache-2.0
// A crack of which the jet is the beginning parts a plane body, also where what it leaves beside
// the jet is crumbs, or a rest of the other side.
#pragma once

#include "analysis/body_sides.hpp"
#include "analysis/kerf_map.hpp"
#include "analysis/pieces.hpp"

namespace kerf {

// Returns whether the body `view.body` of a section (2D) is parted so: on each side one counted
// piece is most of what is intact, not the same on both, and a path of open places (as that of the
// depth of a cut) leads from the face in the space of the jet to the far face.
bool is_parted_by_crack(const BodySides& sides, const KerfView& view, const KerfAxes& axes,
                        const Pieces& pieces);

}  // namespace kerf
