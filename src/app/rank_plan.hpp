// SPDX-License-Identifier: Apache-2.0
// The plan of `kerf check --ranks N`: what a run would cost with 1, 2, 4 ... N ranks, each with its
// threads, found on one machine by dividing the layout of the case as the run does.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cost_advice.hpp"
#include "app/rank_estimate.hpp"

namespace kerf {

inline constexpr int most_planned_ranks = 10000;

struct RankPlan {
  Network network;
  int threads = 1;  // of each rank
  StepWaits waits;
  std::size_t laid_out = 0;  // particles of the layout that was divided
  double refinement = 1.0;   // particles of the case over these
  std::vector<RankEstimate> estimates;

  // The largest number of ranks at which each still does half of what one alone does.
  int paying_ranks() const;
  std::string text() const;
  nlohmann::ordered_json json() const;
};

// Throws UserError where the build has no ranks, or several ranks cannot compute the case. `file`
// stands in the message.
void refuse_unplanned(const Case& description, const std::string& file, int ranks);

// Returns the plan of a case that refuse_unplanned() accepts.
RankPlan rank_plan(const CostedCase& costed, int ranks, int threads, const Network& network);

}  // namespace kerf
