// SPDX-License-Identifier: Apache-2.0
// Shapes, which are regions of space: their interior, bounding box and volume.
#pragma once

#include "model/shape.hpp"

namespace kerf {

// Returns whether the point is inside the shape or on its boundary, to within 1e-9 of its size:
// points on the boundary are inside in spite of rounding, so that symmetric shapes contain
// symmetric points. The tolerance of a mesh, whose file has seven digits, is 1e-6.
bool contains(const Shape& shape, const Point& point, int dimension);

// Returns the bounding box of the shape; for a difference, that of its first part. In 2D the z
// entries are 0.
Box bounding_box(const Shape& shape, int dimension);

// Returns whether the point lies beyond one of these faces of the box.
bool is_beyond(const Faces& faces, const Box& box, const Point& point);

// Returns the volume, m^3 (2D: m^2): closed forms; for a mesh the divergence theorem; for unions
// and differences the share of a fine grid of points in the bounding box, accurate to about 1%.
double volume_estimate(const Shape& shape, int dimension);

}  // namespace kerf
