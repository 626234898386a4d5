// SPDX-License-Identifier: Apache-2.0
// The input of the measurements of a kerf.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/cut.hpp"
#include "analysis/kerf_map.hpp"
#include "analysis/kerf_shape.hpp"

namespace kerf {

// The conditions of a kerf that a frame does not contain.
struct KerfConditions {
  std::array<double, 3> traverse{};  // m/s, velocity of the nozzle
  double moves_from = 0.0;           // s, when the traverse began
  double jet_speed = 0.0;            // m/s
  double on_time_factor = 1.0;       // 1, part of the time since contact in which water flowed
  double energy_of_others = 0.0;     // J (2D: J/m), of the further jets and images since contact
  double contact_time = std::numeric_limits<double>::quiet_NaN();      // s, nan before contact
  double cut_through_time = std::numeric_limits<double>::quiet_NaN();  // s, nan = not cut through
  // s, the end of the run as the case states it, which does not hang on when a run stops after its
  // cut; nan where no case states it: the time of the frame.
  double stated_end = std::numeric_limits<double>::quiet_NaN();
  double front_depth = 0.0;          // m, of the water
  std::vector<BodyVerdict> bodies;   // on each body of the workpiece; empty = not judged
  std::vector<std::uint8_t> traces;  // CutSummary::traces

  // Returns the share of the stated time that is left after a cut at `time`, s, of which a frame at
  // `now` tells.
  double share_after(double time, double now) const {
    const double end = std::isnan(stated_end) ? now : stated_end;
    return end > 0.0 ? (end - time) / end : 0.0;
  }
  // Returns the verdict on a body; none without one.
  const BodyVerdict* verdict_on(int body) const {
    for (const BodyVerdict& verdict : bodies)
      if (verdict.body == body) return &verdict;
    return nullptr;
  }
};

// Returns the conditions for the jets of the case, after a run with this summary.
KerfConditions kerf_conditions(const Case& description, const CutSummary& summary);

// A kerf at one instant: particles, local coordinates, and the standing solid by columns.
struct KerfScene {
  const KerfView& view;    // workpiece, frame and standing particles
  const KerfMap& map;      // of the removed material, in the initial layout
  const KerfAxes& axes;    // local coordinates
  const KerfPath& path;    // of the axis so far
  const KerfShape& shape;  // depth, widths, taper and lag on that map
  const std::vector<Fragment>& fragments;
  const KerfConditions& conditions;
};

}  // namespace kerf
