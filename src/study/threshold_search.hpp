// SPDX-License-Identifier: Apache-2.0
// The value of one key at which a verdict changes, by sections of a bracket:
// docs/theory/searches.md.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/goals.hpp"
#include "study/laboratory.hpp"

namespace kerf {

// Two values of the key: at and before `low` the verdict is one, at and beyond `high` the other.
// Verdicts that alternate in between are within.
struct Bracket {
  double low = 0.0, high = 0.0;  // SI
  double middle() const { return 0.5 * (low + high); }
  double half_width() const { return 0.5 * (high - low); }
};

struct ThresholdAnswer {
  std::string problem;            // why there is no answer; empty when there is one
  Bracket bracket;                // of the study's resolution, over all layouts
  std::vector<Bracket> layouts;   // of each
  std::optional<Bracket> draft;   // of the coarser resolution
  double draft_refinement = 0.0;  // spacings of the drafts were divided by it
  double refinement = 0.0;
  double resolution_change = 0.0;  // SI, middle of the bracket less that of the drafts
  double extrapolated = 0.0;       // SI, estimate for spacing 0
  Bracket stated;                  // the bracket, stretched to the extrapolated value
  int runs = 0, draft_runs = 0;    // that it took
  bool is_within_tolerance = false;
  double value() const { return bracket.middle(); }
};

// `at` is where the other keys stand.
ThresholdAnswer find_threshold(const ThresholdGoal& goal, const Trial& at, Laboratory& laboratory);

}  // namespace kerf
