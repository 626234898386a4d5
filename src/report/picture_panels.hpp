// SPDX-License-Identifier: Apache-2.0
// This header declares the panels of a picture: a flat map with axes and an oblique view.
#pragma once

#include <vector>

#include "report/canvas.hpp"
#include "report/picture.hpp"

namespace kerf {

// Maps the (x, y) plane onto an area of the canvas, with the same scale in both directions.
struct Map {
  Rectangle area;       // px
  double scale = 1.0;   // px/m
  double left = 0.0;    // m, x at the area's left edge
  double bottom = 0.0;  // m, y at its lower edge

  double x(double metres) const { return area.x + (metres - left) * scale; }
  double y(double metres) const { return area.y + area.height - (metres - bottom) * scale; }
};

// Draws particles as plain discs in the order rigid, solid, fractured, water.
void draw_discs(const Canvas& canvas, const Map& map, const Frame& frame,
                const std::vector<std::size_t>& shown);
// Draws a frame with ticks in mm on its left and lower side.
void draw_axes(const Canvas& canvas, const Map& map);

// The unit vectors of an oblique view; `towards` points to the viewer.
struct Sight {
  Point right{}, up{}, towards{};
};
Sight oblique_sight();
// Returns the extent of a box in the coordinates (right, up) of the view.
Box extent_of(const Box& window, const Sight& sight);

// Draws the particles that are not in front of z = `cut` as shaded discs, the farthest first.
void draw_oblique(const Canvas& canvas, const Map& map, const Frame& frame, double cut);

}  // namespace kerf
