// SPDX-License-Identifier: Apache-2.0
// The direction of a jet in space.
#pragma once

#include <cmath>

#include "model/body.hpp"
#include "model/jet.hpp"

namespace kerf {

// Returns the unit vector along the flight of the water.
inline Point jet_direction(const Jet& jet) {
  const double level = std::sin(jet.angle);
  return {level * std::cos(jet.azimuth), -std::cos(jet.angle), level * std::sin(jet.azimuth)};
}

// Returns the water of a jet, along its whole axis, as a line around which bodies are graded.
inline Grading::Line line_of(const Jet& jet) {
  return {jet.position, jet_direction(jet), 0.5 * jet.width};
}

// Returns the plane that the water of a jet sweeps whose nozzle travels.
inline Grading::Line sweep_of(const Jet& jet) {
  Grading::Line line = line_of(jet);
  const double speed = std::hypot(jet.traverse[0], jet.traverse[1], jet.traverse[2]);
  for (std::size_t a = 0; a < 3; ++a) line.sweep[a] = jet.traverse[a] / speed;
  return line;
}

}  // namespace kerf
