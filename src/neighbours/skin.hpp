// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace kerf {

// Returns the skin of the neighbour list in units of the finest spacing. A shorter skin needs more
// searches, a longer one more pairs per pair loop: in 3D their number grows with the cube of the
// cutoff. `step`: how far the fastest jet moves in a time step, in the same unit. The list is to
// hold for three steps of water that a solid turns; the pairs are summed in the middle of a step.
constexpr double list_skin(int dimension, double step) {
  constexpr double steps = 2.55;  // with a margin for steps that become longer
  const double shortest = dimension == 3 ? 0.22 : 0.35, longest = 0.6;
  return std::clamp(steps * step, shortest, longest);
}

}  // namespace kerf
