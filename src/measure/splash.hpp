// SPDX-License-Identifier: Apache-2.0
// Where the water goes that comes back out of a kerf.
#pragma once

#include <limits>

#include "measure/kerf_map.hpp"

namespace kerf {

struct Splash {
  double mass = 0.0;  // kg (2D: kg/m)
  // rad, mean over the mass of the angle between the way of the water and the face: 0 = along the
  // face, pi/2 = straight back; nan without such water.
  double angle = std::numeric_limits<double>::quiet_NaN();
  double spread = std::numeric_limits<double>::quiet_NaN();  // rad, standard deviation
};

// Slower water, as part of the jet's speed, has come to rest: its direction says nothing.
inline constexpr double least_splash_speed = 0.01;

// `map` is that of the whole workpiece, `jet_speed` in m/s.
Splash measure_splash(const KerfView& view, const KerfMap& map, const KerfAxes& axes,
                      const KerfPath& path, double jet_speed);

}  // namespace kerf
