// SPDX-License-Identifier: Apache-2.0
// This header declares the line through the runs of a search that are nearest to a value.
#pragma once

#include <optional>

#include "study/least_squares.hpp"
#include "study/metric_jump.hpp"

namespace kerf {

// A measured value and how far it may be from the true one.
struct Measurement {
  double value = 0.0, uncertainty = 0.0;
};

// Fits a line to the nearest five runs, and to more where the slope is uncertain by more than a
// half or the interval in which the line crosses the measured value reaches beyond these runs: a
// crowd of runs has the slope of its scatter. `root` is a logarithm of the key.
Fit nearest_line(const MetricByKey& runs, double root, const Measurement& measured);

// Returns whether the half-width of the slope's interval is within this share of the slope.
bool has_slope(const Fit& line, double share);

// Returns the keys at which a run may have the measured value, with 95%: those x with
// [y - a - b (x - root)]^2 <= U^2 + t^2 (s^2 + variance of the line at x), which contains the
// uncertainty of the slope (Fieller, J. R. Stat. Soc. B 16 (1954) 175). Needs has_slope(line, 1).
Bracket crossing_interval(const Fit& line, double root, const Measurement& measured);

// Returns a key just outside an interval, on a side where no run is near its end; nothing if there
// are such runs on both sides. The first and last run end the range.
std::optional<double> key_beside(const MetricByKey& runs, const Bracket& interval);

// Returns an interval with its ends at the runs just outside, where there are any.
Bracket to_runs_beside(const MetricByKey& runs, const Bracket& interval);

}  // namespace kerf
