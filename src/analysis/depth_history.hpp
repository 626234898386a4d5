// SPDX-License-Identifier: Apache-2.0
// The history of a cut over the exposure, of a nozzle that stands in the run but has a traverse
// speed (analysis/exposure.hpp).
#pragma once

#include <algorithm>
#include <vector>

#include "analysis/cut.hpp"

namespace kerf {

struct Case;

// The history of a cut over the exposure: the time since contact less that which water takes from
// the surface to the front.
struct DepthHistory {
  std::vector<double> times;     // s, of exposure
  std::vector<double> depths;    // m, of the cut that the water has entered by then
  std::vector<double> contacts;  // s, the time since contact
  std::vector<double> widths;    // m, of the opening at that time, along the traverse
};

// How the water gets to the front.
struct WaterEntry {
  double speed;          // m/s, of the jet
  double fastest_front;  // m/s, that water drives; a crack may run ahead of it
  double spacing;        // m, of its particles: the front is known to within one

  // Returns the exposure after a time since contact, s, that has made a cut of a depth, m.
  double exposure(double since_contact, double depth) const {
    return since_contact - std::min(depth, fastest_front * since_contact) / speed;
  }
};

// Returns how the water of the machine of a case gets to the front.
WaterEntry entry_of(const Case& description);

// Returns the history since contact with a workpiece of the thickness, m. An opening that a crack
// has made is none of the water.
DepthHistory depth_history(const Case& description, const std::vector<CutState>& history,
                           const CutSummary& summary, double thickness);

}  // namespace kerf
