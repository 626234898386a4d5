// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf {

struct Case;

// Returns the case with every spacing divided by `refinement`, including that of a machine's water.
Case refined(Case description, double refinement);

// Returns whether the symmetry planes of a case suit its spacings: no particles lie on a plane, and
// none cuts coarsest cells of a graded body.
bool suits_its_planes(const Case& description);

}  // namespace kerf
