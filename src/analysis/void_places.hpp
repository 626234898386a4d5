// SPDX-License-Identifier: Apache-2.0
// The spaces between solids as laid out: voids within a body, and gaps between bodies.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace kerf {

// A place that the layout leaves empty, with solid above and below it along the jet.
struct VoidPlace {
  std::array<double, 3> position{};  // m, local (analysis/kerf_axes.hpp)
  double size = 0.0;                 // m, of the solid beside it
  std::size_t above = 0;             // index of the next solid above
};

// Returns the places, about a particle apart, in which no solid lies nearer than a particle of the
// full layout would. `solids`: local positions, m; `sizes`: their spacings, m; `spacing`: breadth
// of the columns along the jet, m.
std::vector<VoidPlace> find_void_places(const std::vector<std::array<double, 3>>& solids,
                                        const std::vector<double>& sizes, double spacing);

}  // namespace kerf
