// SPDX-License-Identifier: Apache-2.0
// A window of the workpiece that travels with the nozzle: whenever the nozzle has moved by another
// `shift`, so does the window. Every window is a part of one long block, the path, of which it has
// the layout. The rules are in docs/theory/travelling_frame.md.
#pragma once

#include <cstdint>
#include <optional>

#include "model/shape.hpp"

namespace kerf {

struct Case;
struct Jet;
struct WorkpieceSetting;

struct TravellingFrame {
  std::size_t axis = 0;    // along which the nozzle travels: 0 or 2
  double sign = 1.0;       // of its velocity
  double shift = 0.0;      // m
  double speed = 0.0;      // m/s, of the nozzle
  double start = 0.0;      // s, when the nozzle begins to travel
  Box first;               // m, the window at the start
  Box path;                // m, which all windows make up
  std::uint64_t most = 0;  // shifts until the window is at the end of the path

  // Returns the number of shifts until a time, s.
  std::uint64_t shifts_due(double time) const;
  // Returns by how much the window has moved along the axis after some shifts, m, signed.
  double offset(std::uint64_t shifts) const;
  Box window(std::uint64_t shifts) const;
  // Returns when the nozzle has gone as far beyond the last shift as before any other, s.
  double end_time() const;
};

// A window moves by about its length over this number at a time.
inline constexpr double shifts_per_window = 8.0;

// Returns the edge of the coarsest cells of a workpiece, of which its windows are made, m.
double coarsest_cell(const WorkpieceSetting& workpiece);

// Returns that part of the length of the window along an axis, in whole coarsest cells, m.
double usual_shift(const WorkpieceSetting& workpiece, std::size_t axis);

// Returns the frame of a workpiece whose window travels with this nozzle along x or z.
TravellingFrame travelling_frame(const WorkpieceSetting& workpiece, const Jet& jet);
// Returns that of a case; none where nothing travels.
std::optional<TravellingFrame> travelling_frame(const Case& description);

// Returns the case whose window is that after some shifts. Its nozzle begins to travel at a later
// place of the same path, beside the rear of the window: there it is at the same times.
Case at_shift(const Case& description, std::uint64_t shifts);
// Returns that of the window at a time, s.
Case at_time(const Case& description, double time);

}  // namespace kerf
