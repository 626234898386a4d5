// SPDX-License-Identifier: Apache-2.0
// The straight water of a jet as lines, and where they enter bodies as laid out.
#pragma once

#include <vector>

#include "model/point.hpp"
#include "model/shape.hpp"

namespace kerf {

struct Body;
struct Jet;

// A line along the water of a jet, from the exit of its nozzle on.
struct WaterLine {
  Point origin{}, direction{};  // m, unit vector

  Point at(double way) const;  // m
};

// Returns the axis of a jet whose nozzle has moved for a time, s.
WaterLine axis_line(const Jet& jet, double moved = 0.0);
// Returns lines at the edge of a jet.
std::vector<WaterLine> lines_at_edge(const Jet& jet, int dimension);
// A part of a line, m; there is none where its end is before its begin.
struct WayPart {
  double begin, end;
};
// Returns the part of the line that lies in a box.
WayPart way_within(const Box& box, const WaterLine& line, int dimension);
// Returns the way along the line until it enters a body, m; infinite where it passes beside it.
double way_into(const Body& body, const WaterLine& line, int dimension);

// Returns for how long a nozzle moves before its axis is over one of the bodies, half a spacing
// from its edge, s, at most `longest`: 0 where its water meets one from the start on, or none in
// that time.
double time_beside(const Jet& jet, const std::vector<const Body*>& bodies, double longest,
                   int dimension);

}  // namespace kerf
