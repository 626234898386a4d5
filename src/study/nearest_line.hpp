// SPDX-License-Identifier: Apache-2.0
// This header declares the line through the runs of a search that are nearest to a value.
#pragma once

#include "study/least_squares.hpp"
#include "study/metric_jump.hpp"

namespace kerf {

// Fits a line to the nearest five runs, and to more where the slope is uncertain by more than a
// half. `root` is a logarithm of the key.
Fit nearest_line(const MetricByKey& runs, double root);

// Returns whether the half-width of the slope's interval is within this share of the slope.
bool has_slope(const Fit& line, double share);

}  // namespace kerf
