// SPDX-License-Identifier: Apache-2.0
// Cuts that hold of a nozzle at rest only: one that moves strikes but once, and what gives way
// evades it (docs/theory/exposure.md).
#pragma once

#include <vector>

#include "output/validity.hpp"

namespace kerf {

// Adds the flags on a crack that parted the workpiece ahead of the water, and, for a nozzle with a
// traverse speed, on a workpiece that was pressed ahead by more than its thickness before that.
void add_parting_flags(const RunOutcome& outcome, std::vector<ValidityFlag>& flags);

}  // namespace kerf
