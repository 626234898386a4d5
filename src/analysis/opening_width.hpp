// SPDX-License-Identifier: Apache-2.0
// These functions measure the width of a cut at a depth while it is made, across the jet in the
// plane of the jet and the vertical. The widths of the finished kerf are analysis/kerf_width.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/workpiece.hpp"

namespace kerf {

// Returns the width of the material that is fractured or gone at `depth` of the initial layout, m:
// its area in a layer half a jet width thick, over that thickness. The width is an amount and not
// an extent, so that a fracture far from the jet adds only itself; positions are initial ones, so
// that debris counts where it broke.
double fractured_width(const Workpiece& workpiece, const Frame& frame,
                       const std::vector<std::uint32_t>& rows, double depth);

// Returns the width without intact solid around the axis at `depth` in current positions, m: from
// the nearest particle of a counted piece on one side to the nearest on the other; on a side
// without any, to the edge of the initial workpiece.
double opening_width(const Workpiece& workpiece, const Frame& frame,
                     const std::vector<std::uint32_t>& rows,
                     const std::vector<std::uint8_t>& in_piece, double depth);

}  // namespace kerf
