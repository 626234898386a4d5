// SPDX-License-Identifier: Apache-2.0
// The cut of a moving nozzle from a run with the nozzle at rest. At the traverse speed u the jet
// acts on a point of its path at least for w / u, w its extent along the path, and at most for W /
// u, W the width of the opening that it has made by then: so long it stays within its own hole. The
// depth of the cut is between the depths that a jet at rest reaches by the water of these two
// times, which goes on cutting until the last of it is at the front. Where the run is shorter, the
// depth follows the law h = a t^n, t the exposure, fitted to the depths of the run. The depth is
// that of the cut which the water has entered: a dent below it does not count, nor does a crack
// ahead of the water, and a workpiece is cut once its water is through. No depth is told where the
// front has passed the far face of a workpiece that is not cut. The run counts the pauses of a jet
// that arrives in drops as water: where a point is exposed for a few of them only, no cut is
// certain. The theory and the
// comparison with moving nozzles are in docs/theory/exposure.md.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "analysis/cut.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct Case;

struct Exposure {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double shortest = 0.0;   // s, w / u
  double longest = 0.0;    // s, W / u
  double simulated = 0.0;  // s, the exposure until the water is through or the run ends
  double thickness = 0.0;  // m, of the workpiece along the jet
  // m, of the cut at the traverse speed: after the shortest and the longest exposure, and their
  // geometric mean.
  double depth_low = none, depth_high = none, depth = none;
  double exponent = none;  // n; none where nothing is carried
  // m/s, the traverse speeds up to which the cut is certain, and possible: at most the speed of the
  // jet. 0 = no speed at which it is certain.
  double greatest_feed = none, possible_feed = none;
  // The cut holds of a nozzle at rest only (CutSummary::holds_at_rest_only): no feed is certain.
  bool is_uncertain = false;

  // m/s, the traverse speed from which on the pauses of a jet in drops show on the path: a point of
  // it is exposed for fewer than few_pulses of their periods. Infinite for an intact jet.
  double pausing_feed = std::numeric_limits<double>::infinity();
  bool has_pauses = false;  // at the traverse speed
  static constexpr double few_pulses = 3.0;

  bool cuts() const { return !is_uncertain && !has_pauses && depth_low >= thickness; }
  // Also where the run tells no greatest depth at the traverse speed.
  bool may_cut() const { return !(depth_high < thickness); }
  // Returns the decades of time over which the depth is carried; 0 = the run covers the exposure.
  double decades() const;

  static const MetricList<Exposure>& metrics();
};

// Returns the exposure of a case whose nozzle stands in the run but has a traverse speed; nothing
// for others, and before contact.
std::optional<Exposure> exposure_of(const Case& description, const std::vector<CutState>& history,
                                    const CutSummary& cut);

}  // namespace kerf
