// SPDX-License-Identifier: Apache-2.0
// This header declares the settings at the ends of the ranges that a study searches. Their cases
// are checked before the first run, since a search comes to the ends late.
#pragma once

#include <vector>

#include "study/laboratory.hpp"
#include "study/study_plan.hpp"

namespace kerf {

// Returns the ends of the ranges of the search and the calibration, at each resolution that they
// use, with every prediction. Of an optimum these are the corners of its ranges.
std::vector<Trial> search_ends(const StudyPlan& plan);

}  // namespace kerf
