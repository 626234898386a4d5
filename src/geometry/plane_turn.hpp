// SPDX-License-Identifier: Apache-2.0
// Turns of points and shapes in the plane of x and y, about the origin.
#pragma once

#include <array>
#include <vector>

#include "model/shape.hpp"

namespace kerf {

// The map x -> R(angle) M x, where M mirrors x if `mirrored`, and its inverse.
struct PlaneTurn {
  double c = 1.0, s = 0.0, side = 1.0;

  // `angle` in rad, about z, counterclockwise.
  explicit PlaneTurn(double angle, bool mirrored = false);
  Point operator()(const Point& v) const {
    return {c * side * v[0] - s * v[1], s * side * v[0] + c * v[1], v[2]};
  }
  Point back(const Point& v) const {
    return {side * (c * v[0] + s * v[1]), -s * v[0] + c * v[1], v[2]};
  }
};

// Returns the corners of a box in the plane of x and y, counterclockwise.
std::vector<std::array<double, 2>> corners_of(const Box& box);

// Turns every corner.
void turn_corners(std::vector<std::array<double, 2>>& corners, const PlaneTurn& turn);

// Returns the turned shape, which holds no mesh. A turned box is a polygon, in 3D an extruded one;
// a box that is mirrored only is a box.
Shape turned(Shape shape, const PlaneTurn& turn);

// Returns the smallest box around a turned box; infinite sides of the box make all of it infinite.
Box box_around(const Box& box, const PlaneTurn& turn);

}  // namespace kerf
