// SPDX-License-Identifier: Apache-2.0
// This header declares the searches of a study: the threshold of one key, the best setting, and the
// calibration of a material. docs/theory/searches.md describes them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/goals.hpp"
#include "study/laboratory.hpp"

namespace kerf {

// A bracket of the threshold: up to `low` every verdict is the same, from `high` on every verdict
// is the other. Verdicts that alternate lie in between.
struct Bracket {
  double low = 0.0, high = 0.0;  // SI
  double middle() const { return 0.5 * (low + high); }
  double half_width() const { return 0.5 * (high - low); }
};

struct ThresholdAnswer {
  std::string problem;  // why there is no answer; empty when there is one
  // The verdict of every run where the condition does not change over the range.
  std::optional<bool> holds_everywhere;
  Bracket bracket;                // at the study's resolution, over all layouts
  std::vector<Bracket> layouts;   // one for each layout
  std::optional<Bracket> draft;   // at the coarser resolution
  double draft_refinement = 0.0;  // the spacings of the drafts were divided by it
  double refinement = 0.0;
  double resolution_change = 0.0;  // SI, middle of the bracket minus that of the drafts
  double extrapolated = 0.0;       // SI, estimate for a spacing of 0
  Bracket stated;                  // the bracket, extended to that of the extrapolated value
  int runs = 0, draft_runs = 0;    // number of runs made
  bool is_within_tolerance = false;
  bool alternates = false;  // the verdicts of a layout, or of the drafts, change more than once
  double value() const { return bracket.middle(); }
};

// Finds the value of the goal's key at which its condition begins to hold, by sections of a
// bracket. `at` sets the other keys.
ThresholdAnswer find_threshold(const ThresholdGoal& goal, const Trial& at, Laboratory& laboratory);

// A run that is better than those around it, but not the answer.
struct OtherOptimum {
  Setting setting;
  double value = 0.0;  // of the metric, SI
  double refinement = 1.0;
};

struct OptimumAnswer {
  std::string problem;  // why there is no answer; empty when there is one
  Setting setting;      // of the best of all runs at the study's resolution
  double value =
      0.0;  // of the metric, SI, at the first layout; NaN where the condition held nowhere
  // Of the metric: between the neighbouring runs and over the layouts, extended to `extrapolated`.
  double low = 0.0, high = 0.0;
  // The neighbouring runs along each axis of the goal, SI; an end of the range where there is none.
  std::vector<Bracket> neighbours;
  // Where else the runs have an optimum, at most three of each resolution. Where there are any, the
  // metric has several optima, and the answer is the best of those that were seen.
  std::vector<OtherOptimum> others;
  std::optional<double> draft_value;   // of the draft at that setting, if the condition holds
  std::optional<double> extrapolated;  // estimate for a spacing of 0
  int runs = 0, draft_runs = 0;
};

// Finds the setting with the least or greatest metric among those at which the condition holds. The
// search follows one optimum: better ones may exist between and beyond its runs.
OptimumAnswer find_optimum(const OptimumGoal& goal, double refinement, Laboratory& laboratory);

struct PredictedCut {
  Setting setting;
  double value = 0.0, low = 0.0, high = 0.0;  // of the metric, SI
};

// A jump of a metric between the keys of two neighbouring runs.
struct MetricJump {
  double low = 0.0, high = 0.0;        // of the key, SI
  double at_low = 0.0, at_high = 0.0;  // of the metric, SI
};

struct CalibrationAnswer {
  std::string problem;  // why there is no answer; empty when there is one
  // Of the key, SI. The interval covers it with 95%, within the range that was searched and between
  // the runs that contradict it, and contains all runs that agree with the measurement; across a
  // jump it is the bracket of the jump.
  double value = 0.0, low = 0.0, high = 0.0;
  // Whether the run at the least, or greatest, value of the range agrees with the measurement, too:
  // the key is not determined on that side.
  bool is_open_below = false, is_open_above = false;
  std::optional<MetricJump> jump;  // across the measured value
  double sensitivity = 0.0;  // SI, 0 across a jump; change of the metric per factor e of the key
  double scatter = 0.0;      // SI, standard deviation of the runs about the fit
  int runs = 0;
  std::vector<PredictedCut> predictions;
};

// Finds the value of a material's key at which the metric is as measured.
CalibrationAnswer calibrate(const CalibrationGoal& goal, double refinement, Laboratory& laboratory);

// Returns the value extrapolated to spacing 0 from `fine` at spacing d and `coarse` at r d, with
// `ratio` = r > 1. The error is taken as proportional to the spacing (Richardson, Phil. Trans. R.
// Soc. A 210 (1911) 307, there to its square):  v_0 = v(d) + [v(d) - v(r d)] / (r - 1).
inline double at_zero_spacing(double fine, double coarse, double ratio) {
  return fine + (fine - coarse) / (ratio - 1.0);
}

}  // namespace kerf
