// SPDX-License-Identifier: Apache-2.0
// The face of a pressure gauge, flush with a wall: points that each stand for the same part of it.
#pragma once

#include <vector>

#include "model/point.hpp"

namespace kerf {

// Returns the points of a disc with this centre, unit normal and diameter (m), on four rings; in 2D
// those of a strip of that width in the plane of x and y.
std::vector<Point> gauge_face(const Point& centre, const Point& normal, double diameter,
                              int dimension);

}  // namespace kerf
