// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf {

struct Case;

// Returns the case with every spacing divided by `refinement`, including that of a machine's water.
Case refined(Case description, double refinement);

}  // namespace kerf
