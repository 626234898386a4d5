// SPDX-License-Identifier: Apache-2.0
// A nozzle that travels faster than its own jet: its water does not strike where it left the
// nozzle, and such a feed or pressure is most often a slip of a unit.
#pragma once

#include <optional>
#include <string>

#include "output/validity.hpp"

namespace kerf {

struct Case;

// Returns both speeds with their keys and the remedy, of the first such nozzle; none without one.
std::optional<std::string> fast_nozzle(const Case& description);

// Returns the flag on it.
std::optional<ValidityFlag> fast_nozzle_flag(const Case& description);

}  // namespace kerf
