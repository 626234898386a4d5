// SPDX-License-Identifier: Apache-2.0
// Depth, widths, taper and lag of a kerf. Definitions: docs/metrics.md.
#pragma once

#include <vector>

#include "measure/kerf_map.hpp"

namespace kerf {

struct ProfilePoint {
  double position = 0.0;  // m, along the cut, or from the axis where the nozzle stands still
  double depth = 0.0;     // m, of the kerf below the face
};

struct KerfLevel {
  double below = 0.0;  // m, below the face
  double half = 0.0;   // m, half the thickness of the layer whose mean the width is
  double width = 0.0;  // m
};

struct KerfShape {
  double thickness = 0.0;  // m, of what is cut, along the jet
  double depth = 0.0;      // m, reached below the face, along the jet
  bool through = false;    // depth within one spacing of the thickness
  // 1, part of the way of the axis so far on which it is; of a nozzle that stands still 0 or 1.
  double through_share = 0.0;
  KerfLevel top, middle, bottom;
  double taper = 0.0;  // rad, of one face; positive = narrower below
  double lag = 0.0;    // m, bottom of the cutting front behind its top; nan without such a front
  // Where the nozzle travels: along its way. Else in 2D across the jet, in 3D from the axis out.
  std::vector<ProfilePoint> profile;
};

// All 0 where the path meets no solid. `spacing` is that of the solid beside the axis, m.
KerfShape measure_shape(const KerfMap& map, const KerfAxes& axes, const KerfPath& path,
                        double spacing);

}  // namespace kerf
