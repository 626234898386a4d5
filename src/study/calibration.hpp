// SPDX-License-Identifier: Apache-2.0
// A material's key from one measured cut: docs/theory/searches.md.
#pragma once

#include <string>
#include <vector>

#include "study/goals.hpp"
#include "study/laboratory.hpp"

namespace kerf {

struct PredictedCut {
  Setting setting;
  double value = 0.0, low = 0.0, high = 0.0;  // of the metric, SI
};

struct CalibrationAnswer {
  std::string problem;                        // why there is no answer; empty when there is one
  double value = 0.0, low = 0.0, high = 0.0;  // of the key, SI; the interval covers it with 95%
  double sensitivity = 0.0;                   // SI, change of the metric when the key grows e-fold
  double scatter = 0.0;                       // SI, standard deviation of the runs about that line
  int runs = 0;
  std::vector<PredictedCut> predictions;
};

CalibrationAnswer calibrate(const CalibrationGoal& goal, double refinement, Laboratory& laboratory);

}  // namespace kerf
