// SPDX-License-Identifier: Apache-2.0
// Water that came into whole solid, where none can be.
#pragma once

#include "measure/kerf_map.hpp"

namespace kerf {

struct Leak {
  double mass = 0.0;   // kg (2D: kg/m), of the jet's water inside the solid
  double water = 0.0;  // kg (2D: kg/m), of all of the jet's water that has left the nozzle
  double share() const { return water > 0.0 ? mass / water : 0.0; }
};

// Inside: where intact solid takes more than this part of the space, averaged over a spacing and a
// half. It is 1/2 on a face, 3/4 three fifths of a spacing below it, and at most 3/5 in the middle
// of a gap of one spacing.
inline constexpr float leak_share = 0.75f;

Leak measure_leak(const KerfView& view, const KerfAxes& axes);

}  // namespace kerf
