// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/case.hpp"

namespace kerf {

// The same case with every spacing divided by `refinement`, also that of a machine's water.
Case refined(Case description, double refinement);

}  // namespace kerf
