// SPDX-License-Identifier: Apache-2.0
// Pulses that are shorter than the particles hold come several as one (geometry/nozzle.hpp).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "output/validity.hpp"

namespace kerf {

struct Case;

// Returns what the particles make of the pulses of a jet, with key, value, range and remedy; none
// where each comes as it is.
std::optional<std::string> merged_pulses(const Case& description, std::size_t jet);

// Adds a flag for the first jet of which that is so.
void add_pulse_flag(const Case& description, std::vector<ValidityFlag>& flags);

}  // namespace kerf
