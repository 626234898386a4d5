// SPDX-License-Identifier: Apache-2.0
// The sentence of the verdict on the traverse speed of a nozzle that stands in the run.
#pragma once

#include <string>

namespace kerf {

struct RunOutcome;

// Says what the run means for a nozzle that stands in it and moves at the machine; empty for
// others.
std::string exposure_sentence(const RunOutcome& outcome);

}  // namespace kerf
