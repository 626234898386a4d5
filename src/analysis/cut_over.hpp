// SPDX-License-Identifier: Apache-2.0
// The end of a run that has given its answer before its time is over.
#pragma once

#include <vector>

#include "analysis/cut.hpp"

namespace kerf {

struct Case;

// Returns whether a run of the case may end before its time is over.
bool may_end_early(const Case& description);

// Returns whether it does: the front has come to the end of the simulated part, or the time
// `after_cut` has passed since the workpiece was cut through. `time` in s.
bool is_cut_over(const Case& description, const std::vector<CutState>& history, double time);

// Returns when the run will end, s, if the front goes on at its mean speed so far; at the end of
// its time where it does not end early.
double expected_end(const Case& description, const std::vector<CutState>& history);

}  // namespace kerf
