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

// Returns the number that the key "reduce" selects, over the samples between "from" and "to":
//   last, mean, peak (greatest value), largest (greatest magnitude, with its sign)
//   hann_mean      mean with the weight 1 - cos: the centre of an oscillation
//   peak_of_mean   greatest mean over a stretch of time "over" long
//   slope          of the least-squares line, per second
//   period         mean time between crossings of zero in the same direction
//   first_above, last_above   the time at which the signal reaches "level" (in "level_unit")
//   time_between   the time from first passing "level" to first passing "upper_level"
// NaN if there is none. Throws std::logic_error for an unknown reduction.
double reduce(const TimeSeries& series, const Parameters& parameters);

}  // namespace kerf
