// SPDX-License-Identifier: Apache-2.0
// A time series is a signal over time; reductions turn it into one number.
#pragma once

#include <vector>

#include "verification/parameters.hpp"

namespace kerf {

struct TimeSeries {
  std::vector<double> time;  // s, ascending
  std::vector<double> value;
};

// Returns the value at a time, linear between samples; NaN outside.
double value_at(const TimeSeries& series, double time);

// The number that the key "reduce" asks for, over the samples between "from" and "to":
//   last, mean, peak (greatest value), largest (greatest magnitude, with its sign)
//   hann_mean      mean with the weight 1 - cos: what a swing swings about
//   peak_of_mean   greatest mean over a stretch of time "over" long
//   slope          of the least-squares line, per second
//   period         mean time between crossings of zero in the same direction
//   first_above, last_above   the time the signal is at "level" (in the SI unit "level_unit") or
//   more
// NaN when there is none. Throws std::logic_error for a reduction that is not there.
double reduce(const TimeSeries& series, const Parameters& parameters);

}  // namespace kerf
