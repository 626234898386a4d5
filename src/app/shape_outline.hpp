// SPDX-License-Identifier: Apache-2.0
// This header declares the section of a shape by a vertical plane, as paths of an SVG drawing.
#pragma once

#include <string>
#include <vector>

#include "model/shape.hpp"

namespace kerf {

// The vertical plane of a drawing, and its scale.
struct SectionPlane {
  int dimension = 2;
  std::size_t across = 0;  // horizontal axis of the drawing: 0 = x, 2 = z
  Point through{};         // m, a point of the plane
  Point corner{};          // m, shown at the upper left of the drawing
  double scale = 1.0;      // pixels per m

  double x(const Point& point) const { return scale * (point[across] - corner[across]); }
  double y(const Point& point) const { return scale * (corner[1] - point[1]); }
  std::size_t normal() const { return across == 0 ? 2 : 0; }  // axis of the normal
  Point at(double horizontal, double vertical) const;         // pixels
};

// A part of a section: the commands of a path that is filled by the rule "evenodd".
struct SectionPart {
  std::string path;
  bool is_sampled = false;  // by strips, whose outline is not that of the part
};

// Returns the parts of the section; none where the plane misses the shape. Boxes, round shapes and
// polygons are exact, all others are sampled at every pixel.
std::vector<SectionPart> section_of(const Shape& shape, const SectionPlane& plane);

}  // namespace kerf
