// SPDX-License-Identifier: Apache-2.0
// One row in place of those of several runs: their mean, or the exponent of the law that they
// follow.
#pragma once

#include <vector>

#include "verification/verify.hpp"

namespace kerf {

// Returns the row of the mean of the runs, which have the rows given, with their scatter.
Row mean_of(const std::vector<Row>& rows);

// Returns the row of the exponent n of the law a x^n that fits the measured values best, by least
// squares of the logarithms; `over` holds x of each row. The exponent is NaN where a value is not
// positive.
Row exponent_of(const std::vector<Row>& rows, const std::vector<double>& over);

}  // namespace kerf
