// SPDX-License-Identifier: Apache-2.0
// The best setting that still cuts: docs/theory/searches.md.
#pragma once

#include <optional>
#include <string>

#include "study/goals.hpp"
#include "study/laboratory.hpp"

namespace kerf {

struct OptimumAnswer {
  std::string problem;  // why there is no answer; empty when there is one
  Setting setting;
  double value = 0.0;                  // of the metric, SI, at the first layout
  double low = 0.0, high = 0.0;        // over the layouts, stretched to `extrapolated`
  std::optional<double> draft_value;   // at the same setting, where the condition holds there too
  std::optional<double> extrapolated;  // estimate for spacing 0
  int runs = 0, draft_runs = 0;
};

OptimumAnswer find_optimum(const OptimumGoal& goal, double refinement, Laboratory& laboratory);

}  // namespace kerf
