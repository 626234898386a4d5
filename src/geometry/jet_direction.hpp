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

}  // namespace kerf
