// SPDX-License-Identifier: Apache-2.0
// This header declares a jet of a case as plain data in SI units.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "model/point.hpp"

namespace kerf {

// What the pump of a jet holds: its pressure, so that pressure at the exit slows the water, or the
// flow, whatever pressure that takes.
enum class Feed : std::uint8_t { pressure, flow };
inline constexpr std::array<std::string_view, 2> feed_words{"pressure", "flow"};

// A jet leaves its nozzle at `position - standoff * direction` and flies along
// direction = (sin angle cos azimuth, -cos angle, sin angle sin azimuth). A nozzle that traverses
// moves from there at the time start + dwell on; its water moves with it until it has left.
struct Jet {
  std::string name;
  int material = -1;      // index into Case::materials, a water
  double speed = 0.0;     // m/s, mean over the section
  double width = 0.0;     // m, of a slot; diameter where the nozzle is round
  double length = 0.0;    // m, 3D: of a slot, along `sideways` of JetAxes; 0 = round
  Point slot{};           // unit, at right angles to the jet: that direction; 0 = by the azimuth
  Point position{};       // m, the point on the workpiece that the axis aims at
  double standoff = 0.0;  // m
  double angle = 0.0;     // rad, 0 = straight down
  double azimuth = 0.0;   // rad, 3D only
  double spacing = 0.0;   // m
  double start = 0.0;     // s
  double stop = 0.0;      // s; infinity = as long as the run lasts
  Point traverse{};       // m/s, velocity of the nozzle
  double dwell = 0.0;     // s, rest of the nozzle after `start`
  // s, for which it moves beside the workpiece first, where cuts count from the edge on: the time
  // until its axis is over a body (input/check_jets.cpp).
  double time_beside = 0.0;
  // Water flows for the first `duty` of each period; 0 = without pause.
  double pulse_frequency = 0.0;  // Hz
  double duty = 1.0;             // 1
  // Speed over the section, expression in r (0 on the axis, 1 at the edge), any scale: the mean is
  // normalised to `speed`. "1" = uniform.
  std::string profile = "1";
  Feed feed = Feed::flow;  // the paper's formulation holds the flow only
  bool operator==(const Jet&) const = default;
};

}  // namespace kerf
