// SPDX-License-Identifier: Apache-2.0
// Made-up fronts of a jet at rest over a workpiece, for a nozzle that has a feed.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "analysis/exposure.hpp"
#include "model/case.hpp"

namespace kerf::feeding {

inline constexpr double first_contact = 1e-6;    // s
inline constexpr double slab_thickness = 10e-3;  // m

// A round jet of 1 mm over a workpiece.
inline Case feeding_case(double feed) {
  Case description;
  description.dimension = 3;
  Machine machine;
  machine.traverse_speed = feed;
  machine.motion = NozzleMotion::standing;
  description.machine = machine;
  WorkpieceSetting workpiece;
  workpiece.size = {0.1, slab_thickness, 0.1};
  description.workpiece = workpiece;
  Jet jet;
  jet.width = 1e-3;
  jet.speed = 200.0;
  description.jets.push_back(jet);
  return description;
}

// Returns the time since contact at which an exposure has reached the front at a depth, s.
inline double since_contact(double exposure, double depth) {
  return exposure + depth / feeding_case(1.0).jets[0].speed;
}

// A front whose depth follows from the exposure up to `end`.
inline std::vector<CutState> front_of(const std::function<double(double)>& depth, double end) {
  std::vector<CutState> history;
  for (int k = 0; k <= 500; ++k) {
    CutState state;
    state.front_depth = state.cut_depth = depth(k * end / 500.0);
    state.time = first_contact + since_contact(k * end / 500.0, state.front_depth);
    state.kerf_width = 3e-3;
    history.push_back(state);
  }
  return history;
}

inline CutSummary summary_from(double cut_time = std::numeric_limits<double>::quiet_NaN()) {
  CutSummary cut;
  cut.contact_time = first_contact;
  cut.cut_through = cut_time == cut_time;
  cut.cut_through_time = cut_time;
  return cut;
}

}  // namespace kerf::feeding
