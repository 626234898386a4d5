// SPDX-License-Identifier: Apache-2.0
// The direction of a jet in space, and of its nozzle.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/point_vectors.hpp"
#include "model/body.hpp"
#include "model/jet.hpp"

namespace kerf {

// Unit vectors along the flight of the water; at right angles to it in the plane of the jet and the
// vertical, x for a jet straight down; and along the product of both, z for that jet. Where the jet
// states the direction of its slot, the third is that direction, and the second along its width.
struct JetAxes {
  Point along, across, sideways;
};
// The azimuth is 0 in 2D.
inline JetAxes axes_of(const Jet& jet) {
  const double sine = std::sin(jet.angle), cosine = std::cos(jet.angle);
  const double east = std::cos(jet.azimuth), south = std::sin(jet.azimuth);
  const Point along{sine * east, -cosine, sine * south};
  if (jet.slot != Point{}) return {along, cross(jet.slot, along), jet.slot};
  return {along, {cosine * east, sine, cosine * south}, {-south, 0.0, east}};
}
inline Point jet_direction(const Jet& jet) {
  return axes_of(jet).along;
}

// Returns whether the nozzle is a slot at an angle to an axis of the case, whose water is not its
// own image in planes normal to that axis.
inline bool is_turned_slot(const Jet& jet, std::size_t axis) {
  constexpr double rounding = 1e-9;
  const JetAxes axes = axes_of(jet);
  return jet.length > 0.0 && std::abs(axes.across[axis]) > rounding &&
         std::abs(axes.sideways[axis]) > rounding;
}

// Returns the width (m) of the water of a jet along a unit vector through its axis.
inline double width_along(const Jet& jet, const Point& direction, int dimension) {
  const JetAxes axes = axes_of(jet);
  const double across = std::abs(dot(direction, axes.across)) / jet.width;  // of the width, per m
  if (dimension == 2) return 1.0 / across;
  const double sideways = std::abs(dot(direction, axes.sideways));
  if (jet.length > 0.0) return 1.0 / std::max(across, sideways / jet.length);
  return 1.0 / std::hypot(across, sideways / jet.width);
}

// Returns the speed of the nozzle, m/s.
inline double traverse_speed(const Jet& jet) {
  return std::hypot(jet.traverse[0], jet.traverse[1], jet.traverse[2]);
}

// Returns the water of a jet, along its whole axis, as a line around which bodies are graded.
inline Grading::Line line_of(const Jet& jet) {
  return {jet.position, jet_direction(jet), 0.5 * jet.width};
}

// Returns the plane that the water of a jet sweeps whose nozzle travels.
inline Grading::Line sweep_of(const Jet& jet) {
  Grading::Line line = line_of(jet);
  const double speed = traverse_speed(jet);
  for (std::size_t a = 0; a < 3; ++a) line.sweep[a] = jet.traverse[a] / speed;
  return line;
}

// Returns the water of a jet whose nozzle moves by `way`, m, in the run, as lines at most a width
// of the jet apart; where these would be very many, or `way` is infinite, the plane that it sweeps.
inline std::vector<Grading::Line> lines_along(const Jet& jet, double way) {
  constexpr int most = 64;
  const double speed = traverse_speed(jet);
  if (!(speed > 0.0) || !(way > 0.0)) return {line_of(jet)};
  if (way > most * jet.width) return {sweep_of(jet)};
  const int steps = static_cast<int>(std::ceil(way / jet.width));
  std::vector<Grading::Line> lines;
  for (int n = 0; n <= steps; ++n) {
    lines.push_back(line_of(jet));
    for (std::size_t a = 0; a < 3; ++a)
      lines.back().origin[a] += way * n / steps * (jet.traverse[a] / speed);
  }
  return lines;
}

}  // namespace kerf
