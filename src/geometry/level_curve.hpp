// SPDX-License-Identifier: Apache-2.0
// A level curve of a plane region: the points at one depth below its surface.
#pragma once

#include <optional>
#include <vector>

#include "geometry/nearest_face.hpp"
#include "model/shape.hpp"

namespace kerf {

// The product of the normals of two faces that meet at a corner is less: 30 degrees between them.
inline constexpr double corner_alignment = 0.866;

// The region, and the shapes that cover parts of its surface.
struct CoveredShape {
  const Shape& shape;
  const std::vector<Shape>& others;
  double reach = 0.0;  // m, faces farther away are not sought

  // Returns the nearest face that no other shape covers.
  std::optional<NearestFace> nearest(const Point& point, int dimension) const;
};

// A level curve as a chain of points a `step` apart. At a corner its direction jumps by 30 degrees
// or more; a point of the chain lies at each corner.
struct LevelCurve {
  std::vector<Point> points;         // m
  std::vector<std::size_t> corners;  // numbers of points, ascending
  bool is_closed = false;            // the last point is followed by the first
};

// Follows the curve at `depth` (m) through `start`, with steps of `step` (m), both ways until it
// closes or the surface is covered.
LevelCurve trace_level_curve(const CoveredShape& region, double depth, const Point& start,
                             double step);

// Returns points on the curve that are evenly spaced between its corners, at the distance nearest
// to `spacing` (m) that fits; one at each corner, and half a distance from each end of an open one.
std::vector<Point> spread_on_curve(const LevelCurve& curve, double spacing);

}  // namespace kerf
