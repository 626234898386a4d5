// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace kerf {

// Returns the speed of the front in a solid without strength (kg/m^3, as the water) under a jet of
// the speed V, m/s: the pressures of both streams are equal there (Birkhoff, MacDougall, Pugh &
// Taylor, J. Appl. Phys. 19 (1948) 563).
inline double hydrodynamic_front_speed(double jet_speed, double solid_density,
                                       double water_density) {
  return jet_speed / (1.0 + std::sqrt(solid_density / water_density));
}

}  // namespace kerf
