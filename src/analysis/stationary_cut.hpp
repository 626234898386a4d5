// SPDX-License-Identifier: Apache-2.0
// Whether the cut of a nozzle that travels is stationary: its depth, lag, width and force no longer
// change along the path (docs/theory/travelling_frame.md).
#pragma once

#include <limits>
#include <vector>

#include "analysis/cut.hpp"

namespace kerf {

// The length of path over which a cut is averaged, in jet widths.
inline constexpr double stretch_widths = 4.0;

struct StationaryCut {
  bool reached = false;
  double travelled = 0.0;  // m, by the nozzle so far
  // The largest relative change from one stretch of the path to the next; nan before there are two.
  double change = std::numeric_limits<double>::quiet_NaN();
  // Means over the last stretch.
  double depth = 0.0, lag = 0.0, width = 0.0;  // m
  double force = 0.0;  // N (2D: N/m), of the water on the workpiece, along the jet

  static const MetricList<StationaryCut>& metrics();
};

// Judges the last two stretches of a history in order of time. `time.stop_tolerance` is the largest
// change of a stationary cut. That of a length is relative to the jet width where that is
// larger than the length.
StationaryCut stationary_cut(const Case& description, const std::vector<CutState>& history);

}  // namespace kerf
