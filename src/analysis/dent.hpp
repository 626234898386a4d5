// SPDX-License-Identifier: Apache-2.0
// How far the solid in the way of the jet has become thinner, and how far it has moved as a whole.
// Both compare the particles with the initial layout, so that they are exact far below a spacing.
#pragma once

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

// The workpiece is measured on material lines: lines along the jet in its space, one spacing apart
// in the initial layout. Their ends are the first and the last standing particle of each set of
// joined bodies.
struct Dent {
  double depth = 0.0;   // m, by which a line has become shorter, whatever its motion
  double motion = 0.0;  // m, by which its far end has moved in any direction
  double sag = 0.0;     // m, by which its far end has moved along the jet
  double aside = 0.0;   // m, by which its far end has moved across the jet

  static Dent measure(const KerfScene& scene);
  static const MetricList<Dent>& metrics();
};

}  // namespace kerf
