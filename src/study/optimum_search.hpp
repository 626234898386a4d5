// SPDX-License-Identifier: Apache-2.0
// The best setting that still cuts: docs/theory/searches.md.
#pragma once

#include <string>

#include "study/goals.hpp"
#include "study/laboratory.hpp"

namespace kerf {

struct OptimumAnswer {
  std::string problem;  // why there is no answer; empty when there is one
  Setting setting;
  double value = 0.0;            // of the metric, SI, at the first layout
  double low = 0.0, high = 0.0;  // over the layouts
  double draft_value = 0.0;      // at the coarser resolution, the same setting
  bool has_draft = false;
  int runs = 0, draft_runs = 0;
};

OptimumAnswer find_optimum(const OptimumGoal& goal, double refinement, Laboratory& laboratory);

}  // namespace kerf
