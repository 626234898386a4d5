// SPDX-License-Identifier: Apache-2.0
// The panels that pictures are put together from.
#pragma once

#include <vector>

#include "report/canvas.hpp"
#include "report/picture.hpp"

namespace kerf {

// A flat map of the (x, y) plane onto an area of the canvas, the same scale both ways.
struct Map {
  Rectangle area;       // px
  double scale = 1.0;   // px/m
  double left = 0.0;    // m, x at the area's left edge
  double bottom = 0.0;  // m, y at its lower edge

  double x(double metres) const { return area.x + (metres - left) * scale; }
  double y(double metres) const { return area.y + area.height - (metres - bottom) * scale; }
};

// A distance of 1, 2 or 5 times a power of ten that divides `length` into about `parts`.
double round_interval(double length, double parts);

// Particles as plain discs: rigid, solid, fractured, water, in that order.
void draw_discs(const Canvas& canvas, const Map& map, const Frame& frame,
                const std::vector<std::size_t>& shown);
// A frame with ticks in mm on its left and lower side.
void draw_axes(const Canvas& canvas, const Map& map);

// A direction of sight, for the oblique view. Lengths in m, sight is a unit vector to the eye.
struct Sight {
  Point right{}, up{}, towards{};
};
Sight oblique_sight();
// Extent of a box seen from there, as (right, up).
Box extent_of(const Box& window, const Sight& sight);

// Particles not in front of z = `cut`, from the farthest to the nearest, as shaded discs.
void draw_oblique(const Canvas& canvas, const Map& map, const Frame& frame, double cut);

}  // namespace kerf
