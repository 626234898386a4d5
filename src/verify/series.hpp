// SPDX-License-Identifier: Apache-2.0
// A signal over time, and how it becomes one number.
#pragma once

#include <vector>

#include "verify/parameters.hpp"

namespace kerf {

struct TimeSeries {
  std::vector<double> time;   // s, ascending
  std::vector<double> value;
};

// The number that the key "reduce" asks for, over the samples between "from" and "to":
//   last, mean, peak (greatest value), largest (greatest magnitude, with its sign)
//   slope          of the least-squares line, per second
//   period         mean time between crossings of zero in the same direction
//   first_above, last_above   the time, with "level" (in the SI unit `unit` of the signal)
// NaN when there is none. Throws std::logic_error for a reduction that is not there.
double reduce(const TimeSeries& series, const Parameters& parameters);

}  // namespace kerf
