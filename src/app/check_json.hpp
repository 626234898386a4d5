// SPDX-License-Identifier: Apache-2.0
// What `kerf check` finds, for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/checked_case.hpp"

namespace kerf {

// Returns particles, steps, memory and time of a run, in SI units.
nlohmann::ordered_json cost_object(const DerivedNumbers& numbers, const Pace& pace);

// Returns a checked case as JSON, in SI units: the case, the sentences, the derived numbers by
// their names in result.json, the cost, what to change where that is too much, and the plan of
// ranks where it is asked for (docs/mpi.md).
nlohmann::ordered_json check_object(const CheckedCase& checked);
std::string check_json(const CheckedCase& checked);

}  // namespace kerf
