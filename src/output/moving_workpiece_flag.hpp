// SPDX-License-Identifier: Apache-2.0
// A kerf is measured on the workpiece as laid out, along the path of the nozzle, so that a nozzle
// at rest cuts a workpiece that crosses its jet elsewhere than where it is measured.
#pragma once

#include <optional>

#include "output/validity.hpp"

namespace kerf {

struct Case;

// Returns the flag on a body that can be cut, moves and crosses the first jet, beside the way of
// the nozzle, by more than half its width: by its displacement or at its velocity of the start;
// none if no body does.
std::optional<ValidityFlag> moving_workpiece_flag(const Case& description);

}  // namespace kerf
