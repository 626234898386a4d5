// SPDX-License-Identifier: Apache-2.0
// The shape of a kerf: depth, widths, taper and lag. docs/metrics.md has the definitions.
#pragma once

#include <vector>

#include "analysis/kerf_map.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct ProfilePoint {
  double position = 0.0;  // m, along the cut, or from the axis for a nozzle at rest
  double depth = 0.0;     // m, of the kerf below the face
};

struct KerfLevel {
  double below = 0.0;  // m, below the face
  double half = 0.0;   // m, half the thickness of the layer whose mean the width is
  double width = 0.0;  // m; nan in a gap between two layers
};

struct KerfShape {
  double thickness = 0.0;  // m, of the workpiece or layer, along the jet
  double depth = 0.0;      // m, reached below the face, along the jet
  bool through = false;    // depth within one spacing of the thickness
  // 1, share of the path of the axis since contact on which it is; 0 or 1 for a nozzle at rest
  double through_share = 0.0;
  KerfLevel top, middle, bottom;
  double taper = 0.0;  // rad, of one face; positive = narrower below
  double lag = 0.0;    // m, bottom of the cutting front behind its top; nan without such a front
  // Along the path of a nozzle that travels; for a nozzle at rest, in 2D across the jet, in 3D over
  // the distance from the axis.
  std::vector<ProfilePoint> profile;

  // "{}" in labels and meanings is replaced by the object: a kerf, an opening, a layer.
  static const MetricList<KerfShape>& metrics();
};

// Measures the shape; all numbers are 0 where the path meets no solid. `spacing` is that of the
// solid beside the axis, m.
KerfShape measure_shape(const KerfMap& map, const KerfAxes& axes, const KerfPath& path,
                        double spacing);

}  // namespace kerf
