// SPDX-License-Identifier: Apache-2.0
// nearest_face() finds the point of the surface of rigid bodies that is nearest to a point inside
// them.
#pragma once

#include <optional>
#include <vector>

#include "model/shape.hpp"

namespace kerf {

// The plane that touches the surface at its point nearest to a point inside.
struct NearestFace {
  Point normal{};      // 1, outward unit vector; between two faces the mean of both
  double depth = 0.0;  // m, of the point below the surface
  Point corner{};      // 1, c between two faces, whose normals are n + c and n - c; otherwise 0
};

// Returns the face nearest to `point`, which is inside `shape`. Only faces count that neither
// another part of the shape nor a shape of `others` covers. Faces farther away than `reach` (m) are
// not sought: the result is then empty, as it is beside a crease of a union at which no face of its
// parts ends. The tip of a notch sharper than 90 degrees is passed over where the way to it does
// not point into the notch.
std::optional<NearestFace> nearest_face(const Shape& shape, const std::vector<Shape>& others,
                                        const Point& point, double reach, int dimension);

// Returns whether a face of the shape or of any of its parts is within `reach`, m, of a point.
bool is_near_face(const Shape& shape, const Point& point, double reach, int dimension);

}  // namespace kerf
