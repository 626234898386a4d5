// SPDX-License-Identifier: Apache-2.0
// This measurement finds the mass and direction of the water that flies back off the workpiece.
#pragma once

#include <limits>

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct Splash {
  double mass = 0.0;  // kg (2D: kg/m)
  // rad, mass-weighted mean angle between the water's velocity and the face: 0 = along the face,
  // pi/2 = straight back; nan without such water.
  double angle = std::numeric_limits<double>::quiet_NaN();
  double spread = std::numeric_limits<double>::quiet_NaN();  // rad, standard deviation

  static Splash measure(const KerfScene& scene);
  static const MetricList<Splash>& metrics();
};

// Water slower than this share of the jet's speed counts as at rest, for its direction is
// arbitrary.
inline constexpr double least_splash_speed = 0.01;

}  // namespace kerf
