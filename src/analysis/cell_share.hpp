// SPDX-License-Identifier: Apache-2.0
// This function computes the part of a particle that lies in a layer.
#pragma once

#include <algorithm>

namespace kerf {

// Returns the part of the interval [x - size/2, x + size/2] that lies within half of `thickness`
// from 0.
inline double cell_share(double x, double size, double thickness) {
  const double low = std::max(x - size / 2.0, -thickness / 2.0);
  const double high = std::min(x + size / 2.0, thickness / 2.0);
  return std::max(0.0, high - low) / size;
}

}  // namespace kerf
