// SPDX-License-Identifier: Apache-2.0
// The surface of a shape as small elements, whose areas add up to the area of the surface.
#pragma once

#include <vector>

#include "geometry/symmetry_planes.hpp"
#include "model/shape.hpp"

namespace kerf {

struct SurfaceElement {
  Point position{};   // m, its middle
  Point normal{};     // unit vector, outward
  double area = 0.0;  // m^2 (2D: m)
};

// Returns elements of edges of at most about `size`, m. The areas of plane and round faces are
// exact; where one part of a union or difference cuts a face of another, elements belong to the
// surface by their middle. In 3D the flat ends of an extruded polygon are counted in squares, whose
// areas are scaled to that of the polygon. Symmetry planes cut elements: what lies beyond a plane
// or in it, to within a quarter of `size`, is no part of the surface.
std::vector<SurfaceElement> surface_elements(const Shape& shape, int dimension, double size,
                                             const SymmetryPlanes& symmetry = {});

// Returns those of them whose middle lies in the region.
std::vector<SurfaceElement> surface_elements_within(const Shape& region, const Shape& shape,
                                                    int dimension, double size,
                                                    const SymmetryPlanes& symmetry = {});

}  // namespace kerf
