// SPDX-License-Identifier: Apache-2.0
// How broad the cut is at a depth, across the jet in the plane of the jet and the vertical.
#pragma once

#include <cstdint>
#include <vector>

#include "measure/workpiece.hpp"

namespace kerf {

// Breadth of the material that is fractured or gone, at `depth` of the first layout, m: its area in
// a layer half a jet width thick, over that thickness. An amount, not an extent, so that single
// fractures far from the jet add only themselves; in the first layout, so that debris counts where
// it was broken, not where it flew.
double fractured_width(const Workpiece& workpiece, const Frame& frame,
                       const std::vector<std::uint32_t>& rows, double depth);

// Breadth free of intact solid around the axis at `depth` now, m: from the nearest particle of a
// counted piece on one side to the nearest on the other; on a side without any, to the edge of the
// workpiece as laid out.
double kerf_width(const Workpiece& workpiece, const Frame& frame,
                  const std::vector<std::uint32_t>& rows, const std::vector<std::uint8_t>& in_piece,
                  double depth);

}  // namespace kerf
