// SPDX-License-Identifier: Apache-2.0
// The workpiece of a machine as an operator states it, and the part of it that is simulated, as
// plain data in SI units. src/machine/simulated_piece.hpp chooses that part.
#pragma once

#include "model/point.hpp"
#include "model/shape.hpp"

namespace kerf {

// A slab whose upper face lies at y = 0, with its middle at the origin.
struct WorkpieceSetting {
  Point size{};                // m, along x, y (the thickness) and z
  Box part;                    // m, what is simulated of it
  int levels = 0;              // of resolution beside the finest; 0 = one spacing
  double grading_width = 0.0;  // m, distance from the jet at which the spacing doubles
  double spacing = 0.0;        // m, the finest
  bool operator==(const WorkpieceSetting&) const = default;
};

// Name of the body that the section [workpiece] makes.
inline constexpr const char* workpiece_name = "workpiece";

}  // namespace kerf
