// SPDX-License-Identifier: Apache-2.0
// The workpiece of a machine as an operator states it, and the part of it that is simulated, as
// plain data in SI units. src/machine/simulated_piece.hpp chooses that part.
#pragma once

#include <array>
#include <string_view>

#include "model/point.hpp"
#include "model/shape.hpp"

namespace kerf {

// What the run simulates of the workpiece: one part, or a window that travels with the nozzle.
enum class WorkpieceFrame { fixed, travelling };
inline constexpr std::array<std::string_view, 2> workpiece_frame_words{"fixed", "travelling"};

// A slab whose upper face lies at y = 0, with its middle at the origin.
struct WorkpieceSetting {
  Point size{};                // m, along x, y (the thickness) and z
  double depth = 0.0;          // m, what is simulated of the thickness, from the upper face on
  Box part;                    // m, what is simulated of it, at the start
  int levels = 0;              // of resolution beside the finest; 0 = one spacing
  double grading_width = 0.0;  // m, distance from the jet at which the spacing doubles
  double spacing = 0.0;        // m, the finest
  WorkpieceFrame frame = WorkpieceFrame::fixed;
  double shift = 0.0;  // m, by which a travelling window moves at a time
  bool operator==(const WorkpieceSetting&) const = default;
};

// Name of the body that the section [workpiece] makes.
inline constexpr const char* workpiece_name = "workpiece";

}  // namespace kerf
