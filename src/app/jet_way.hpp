// SPDX-License-Identifier: Apache-2.0
// The way of the water of a jet as laid out.
#pragma once

#include <limits>

namespace kerf {

struct Body;
struct Jet;
struct JetAxis;

// The depths of a body along a jet, of the corners of its bounding box, m.
struct Depths {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;

  Depths(const Body& body, const JetAxis& axis, int dimension);
};

// Returns whether a body is in the way of a jet: whether points of the water are within it, as far
// aside as the analysis counts a body as in its way (analysis/workpiece.hpp).
bool is_in_way(const Jet& jet, const Body& body, int dimension);

}  // namespace kerf
