// SPDX-License-Identifier: Apache-2.0
// This header declares jumps of a metric between neighbouring runs, such as that of a depth to 0
// where a crack parts the workpiece: no value of the key gives what lies in between.
#pragma once

#include <map>
#include <optional>

#include "study/searches.hpp"

namespace kerf {

// The runs of a search: the metric by the logarithm of the key.
using MetricByKey = std::map<double, double>;

// Returns the jump across `target` between the neighbouring runs `low` and `high`, logarithms of
// the key; nothing where the metric is continuous as far as the runs show. It is a jump where
// - all runs on one side are below the target and all on the other side above it, and
// - between the two the metric changes by at least a quarter of what it changes over all runs,
//   three times as much as the runs of a side scatter about the line through those nearest, and
//   twice as much as between the next neighbours of equal distance.
std::optional<MetricJump> find_jump(const MetricByKey& runs, double low, double high,
                                    double target);

// Returns the ends of an interval about `root`, logarithms of the key, shortened to the nearest run
// on each side from which on all runs miss the target by more than `uncertainty`.
Bracket supported_interval(const MetricByKey& runs, double root, const Bracket& interval,
                           double target, double uncertainty);

// Returns an interval lengthened to the farthest runs that agree with the target within
// `uncertainty`, and from there to the next run that does not or, where there is none, to the run
// at the end.
Bracket agreeing_interval(const MetricByKey& runs, const Bracket& interval, double target,
                          double uncertainty);

// Returns the middle of the widest part of an agreeing interval, beyond `interval` and wider than
// `tolerance`, within which the runs change from agreeing to missing; nothing if there is none.
std::optional<double> undecided_value(const MetricByKey& runs, const Bracket& interval,
                                      double target, double uncertainty, double tolerance);

}  // namespace kerf
