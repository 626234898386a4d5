// SPDX-License-Identifier: Apache-2.0
// What `kerf check` finds, for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cost_advice.hpp"

namespace kerf {

// A case that was checked, with what is printed of it.
struct CheckedCase {
  CostedCase costed;
  std::vector<std::string> piece;     // what is simulated and why, a sentence each
  std::vector<std::string> warnings;  // a sentence each
  double memory = 0.0;                // bytes, of this machine
};

// Returns particles, steps, memory and time of a run, in SI units.
nlohmann::ordered_json cost_object(const DerivedNumbers& numbers, const Pace& pace);

// Returns it as JSON, in SI units: the case, the sentences, the derived numbers by their names in
// result.json, the cost, and what to change where that is too much.
std::string check_json(const CheckedCase& checked);

}  // namespace kerf
