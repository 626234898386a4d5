// SPDX-License-Identifier: Apache-2.0
// lay_along_surface() replaces the outermost particles of a plane body by layers that are parallel
// to its surface (docs/theory/layout.md).
#pragma once

#include <optional>
#include <vector>

#include "geometry/nearest_face.hpp"
#include "model/point.hpp"
#include "model/shape.hpp"

namespace kerf {

struct Body;

// The surface is that of `body` which no shape of `others` covers. `depth`, m: how deep the layers
// reach at least.
struct SurfaceLayers {
  const Body& body;
  std::vector<Shape> others;
  double depth = 0.0;
};

// Replaces the nodes of the body's lattice at `points` (m) that are less than `depth` below the
// surface by particles at the depths d/2, 3d/2, 5d/2, ... that are evenly spaced along it. A body
// all of whose nodes are at such depths, a box above all, stays as it is. Returns the nearest face
// of each particle; it is empty where there is none within `depth`. Graded bodies and those in 3D
// stay as they are.
std::vector<std::optional<NearestFace>> lay_along_surface(const SurfaceLayers& layers,
                                                          int dimension,
                                                          std::vector<Point>& points);

// Returns the nearest face of each particle, which stays where it is.
std::vector<std::optional<NearestFace>> nearest_faces(const SurfaceLayers& layers, int dimension,
                                                      const std::vector<Point>& points);

}  // namespace kerf
