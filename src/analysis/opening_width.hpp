// SPDX-License-Identifier: Apache-2.0
// These functions measure the widths of a cut at a depth while it is made, in sections across the
// jet whose directions do not hang on the axes of the case. The widths of the finished kerf are
// analysis/kerf_width.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "analysis/workpiece.hpp"

namespace kerf {

// A line across the jet, along which a width is measured, and the direction at right angles to
// both.
struct OpeningLine {
  std::array<double, 3> along{};  // unit
  std::array<double, 3> aside{};  // unit; 0 in 2D
};

// Returns the lines along which the opening of a case is measured. In 3D they are: across the path
// of a nozzle that travels; along the path of the nozzle for which one stands; else eight, evenly
// around the jet, of whose widths the mean counts.
std::vector<OpeningLine> opening_lines(const Case& description, const JetAxis& jet);

// Returns the places of the axis at which the opening is measured, m from where it aims: in 3D
// those that a nozzle that travels has passed between two times, s, else that aim.
std::vector<std::array<double, 3>> opening_places(const Workpiece& workpiece, double from,
                                                  double until);

// Where an opening is measured.
struct OpeningProbe {
  const std::vector<OpeningLine>& lines;
  std::vector<std::array<double, 3>> places;  // m
  double depth = 0.0;                         // m, in the initial layout
  double depth_now = 0.0;                     // m, of the same place of a workpiece that has moved
};

// The widths of an opening, m: means over the lines, and of these the medians over the places at
// which solid is laid out in the way of the jet; 0 without such a place.
struct OpeningWidths {
  // Of the material that is fractured or gone: its area in a layer half a jet width thick, over
  // that thickness. The width is an amount and not an extent, so that a fracture far from the jet
  // adds only itself; positions are initial ones, so that debris counts where it broke.
  double fractured = 0.0;
  // Without intact solid around the axis in current positions: from the nearest particle of a
  // counted piece on one side to the nearest on the other; on a side without any, to the edge of
  // the initial workpiece.
  double open = 0.0;
  // Of these, what the layout leaves empty around the axis: a void in the workpiece.
  double laid_out = 0.0;
};

OpeningWidths measure_opening(const Workpiece& workpiece, const Frame& frame,
                              const std::vector<std::uint32_t>& rows,
                              const std::vector<std::uint8_t>& in_piece, const OpeningProbe& probe);

}  // namespace kerf
