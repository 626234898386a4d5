// SPDX-License-Identifier: Apache-2.0
// The cut behind a nozzle that travels, at one instant.
#pragma once

#include "analysis/kerf_map.hpp"

namespace kerf {

// The lag is a mean over this many levels between these shares of the depth.
inline constexpr int front_levels = 8;
inline constexpr double front_low = 0.5, front_high = 0.9;

// In the initial layout (docs/theory/travelling_frame.md); 0 before anything is cut.
struct Wake {
  double depth = 0.0;  // m, mean over the deeper half of the path of the axis
  double lag = 0.0;    // m, of the lower part of the front behind the nozzle, along its path
  double width = 0.0;  // m, across the path at half the depth; 0 in 2D
};

// Measures the cut along the path of the axis until the time of the frame.
Wake measure_wake(const KerfView& view, const KerfAxes& axes);

}  // namespace kerf
