// SPDX-License-Identifier: Apache-2.0
// Regions of space: what is inside, how far they reach, how large they are.
#pragma once

#include "model/case.hpp"

namespace kerf {

// True inside the shape and on its boundary, to within 1e-9 of its size: a point that lies on the
// boundary is inside whatever the rounding, so that symmetric shapes hold symmetric points. Of a
// mesh, whose file has seven digits, to within 1e-6.
bool contains(const Shape& shape, const Point& point, int dimension);

// The smallest box around the shape; of a difference, around its first part. In 2D the z entries
// are 0.
Box bounding_box(const Shape& shape, int dimension);

// Whether the point lies beyond one of these faces of the box.
bool is_beyond(const Faces& faces, const Box& box, const Point& point);

// m^3 (m^2 in 2D): closed forms, of a mesh by the divergence theorem, and for unions and
// differences the share of a fine grid of points in the bounding box, good to about 1%.
double volume_estimate(const Shape& shape, int dimension);

}  // namespace kerf
