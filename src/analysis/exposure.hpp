// SPDX-License-Identifier: Apache-2.0
// The cut of a moving nozzle from a run with the nozzle at rest. A jet that moves at the traverse
// speed u acts on a point of its path for the exposure time t_e = w / u, w its extent along the
// path; the depth of its cut is that of a jet at rest after t_e. Where the run is shorter, the
// depth follows the law h = a (t - t_0)^n with t_0 the time of contact, fitted to the deepest front
// of the run. The theory, the interval and its comparison with moving nozzles are in
// docs/theory/exposure.md.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "analysis/cut.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct Case;

// A depth h = a t^n over the time t since contact, m and s.
struct DepthLaw {
  double factor = 0.0;    // a
  double exponent = 0.0;  // n
  double at(double time) const;
};

// The history of the deepest front: times since contact (s) and depths (m).
struct DepthHistory {
  std::vector<double> times, depths;
};

// Returns the law that fits the depths after the share `from` of the time best, by least squares of
// the logarithms; nothing from fewer than five times.
std::optional<DepthLaw> fit_depth(const DepthHistory& history, double from);

struct Exposure {
  double time = 0.0;       // s, t_e
  double simulated = 0.0;  // s, since contact, until the cut or the end of the run
  double thickness = 0.0;  // m, of the workpiece along the jet
  bool cuts = false;       // whether the traverse cuts through
  // m, of the cut of the traverse, with its interval.
  double depth = std::numeric_limits<double>::quiet_NaN();
  double depth_low = depth, depth_high = depth;
  double exponent = std::numeric_limits<double>::quiet_NaN();  // n; none where nothing is carried
  // m/s, the greatest traverse speed that cuts through.
  double greatest_feed = std::numeric_limits<double>::quiet_NaN();

  // Returns the decades of time over which the depth is carried; 0 = the run covers the exposure.
  double decades() const;

  static const MetricList<Exposure>& metrics();
};

// Returns the exposure of a case whose nozzle stands in the run but has a traverse speed; nothing
// for others, and before contact.
std::optional<Exposure> exposure_of(const Case& description, const std::vector<CutState>& history,
                                    const CutSummary& cut);

}  // namespace kerf
