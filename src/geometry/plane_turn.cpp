// SPDX-License-Identifier: Apache-2.0
#include "geometry/plane_turn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {

PlaneTurn::PlaneTurn(double angle, bool mirrored)
    : c(std::cos(angle)), s(std::sin(angle)), side(mirrored ? -1.0 : 1.0) {}

std::vector<std::array<double, 2>> corners_of(const Box& box) {
  return {{box.minimum[0], box.minimum[1]},
          {box.maximum[0], box.minimum[1]},
          {box.maximum[0], box.maximum[1]},
          {box.minimum[0], box.maximum[1]}};
}

void turn_corners(std::vector<std::array<double, 2>>& corners, const PlaneTurn& turn) {
  for (auto& corner : corners) {
    const Point at = turn({corner[0], corner[1], 0.0});
    corner = {at[0], at[1]};
  }
}

Shape turned(Shape shape, const PlaneTurn& turn) {
  if (shape.kind == Shape::Kind::box && turn.s != 0.0) {
    shape.kind = Shape::Kind::polygon;
    shape.vertices = corners_of(shape.box);
    shape.depth_minimum = shape.box.minimum[2];
    shape.depth_maximum = shape.box.maximum[2];
  } else if (shape.kind == Shape::Kind::box) {
    const Point a = turn(shape.box.minimum), b = turn(shape.box.maximum);
    for (std::size_t k = 0; k < 3; ++k) {
      shape.box.minimum[k] = std::min(a[k], b[k]);
      shape.box.maximum[k] = std::max(a[k], b[k]);
    }
  }
  turn_corners(shape.vertices, turn);
  shape.centre = turn(shape.centre);
  shape.axis = turn(shape.axis);
  for (Shape& part : shape.parts) part = turned(part, turn);
  return shape;
}

Box box_around(const Box& box, const PlaneTurn& turn) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box around = box;
  for (std::size_t a = 0; a < 2; ++a) {
    around.minimum[a] = infinity;
    around.maximum[a] = -infinity;
  }
  for (const auto& corner : corners_of(box)) {
    const Point at = turn({corner[0], corner[1], 0.0});
    for (std::size_t a = 0; a < 2; ++a) {
      around.minimum[a] = std::isfinite(at[a]) ? std::min(around.minimum[a], at[a]) : -infinity;
      around.maximum[a] = std::isfinite(at[a]) ? std::max(around.maximum[a], at[a]) : infinity;
    }
  }
  return around;
}

}  // namespace kerf
