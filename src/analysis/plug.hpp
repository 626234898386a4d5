// SPDX-License-Identifier: Apache-2.0
// A plug: the solid under the jet is apart from the rim around it, as where a plate is punched over
// an opening. The plug joins the two sides of the jet as long as they are looked at beside the jet
// alone (analysis/body_sides.hpp); here the rim beyond it is.
#pragma once

#include <cstdint>

#include "analysis/kerf_axes.hpp"

namespace kerf {

struct Pieces;
struct Workpiece;

// How the solid of a body under the jet hangs together with the rest of it.
enum class PlugState {
  held,    // a piece joins it with the rim on a side, or there is no rim
  crumbs,  // it is apart from the rim and in pieces that are too small to count
  apart    // it is apart from the rim, and a piece that counts
};

// Finds out whether the pieces of a body that join the sides of the jet end within the thickness of
// the body, or the width of the jet if that is more, of the jet, and intact solid in counted pieces
// was laid out beyond their end: on both sides in a direction across the jet or, in 3D, all around
// the pieces on its axis. Solid that the initial layout does not join with that on the axis is left
// out. `axes`: those of the jet where it is now.
PlugState find_plug(const Workpiece& workpiece, std::uint16_t body, const KerfAxes& axes,
                    const Pieces& pieces);

}  // namespace kerf
