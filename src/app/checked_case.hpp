// SPDX-License-Identifier: Apache-2.0
// This header declares what kerf check finds about a case.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cost_advice.hpp"
#include "app/rank_plan.hpp"

namespace kerf {

// A case that was checked, with what is printed of it.
struct CheckedCase {
  CostedCase costed;
  std::vector<std::string> piece;      // what is simulated and why, a sentence each
  std::vector<std::string> warnings;   // a sentence each
  double memory = 0.0;                 // bytes, of this machine
  std::optional<RankPlan> ranks = {};  // where it is asked for
  bool is_refused = false;             // by a run, which the first warning says
};

// Returns everything but the pace, which takes seconds. Throws the CaseError of a case that is not
// valid.
CheckedCase checked_case(const std::string& text, const std::string& file);

// Returns whether a run accepts the case, in a clause.
std::string verdict_of(const CheckedCase& checked);

// Reads a case quickly; nothing where it is not valid.
std::optional<Case> valid_case(const std::string& text, const std::string& file);

}  // namespace kerf
