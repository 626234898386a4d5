// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf {

// Returns the skin of the neighbour list in units of the finest spacing. A shorter skin needs more
// searches, a longer one more pairs per pair loop: in 3D their number grows with the cube of the
// cutoff.
constexpr double list_skin(int dimension) {
  return dimension == 3 ? 0.22 : 0.35;
}

}  // namespace kerf
