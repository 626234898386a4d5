// SPDX-License-Identifier: Apache-2.0
// The coarser spacings at which a case is run to see what its spacing leaves open. Symmetry planes
// allow few of them: at each a jet in a plane has an even number of columns, no particles of a body
// lie on a plane, and none cuts coarsest cells of a graded body.
#pragma once

namespace kerf {

struct Case;

// The spacings r d and, where there are two, r^2 d.
struct CoarserSpacings {
  double ratio = 0.0;
  int count = 2;
};

// Returns the spacings of --converge. r is from 1.26 to 1.41, so that the coarsest has at least
// five particles across the jet; where symmetry planes do not allow that it is the nearest that
// they do, up to 2 and with four particles across the jet. Where no two suit, there is one.
CoarserSpacings convergence_spacings(const Case& description);

// Returns how many times larger the spacing of a draft of `kerf limit --converge` is: 2, or sqrt 2
// where it would otherwise have fewer than five particles across the jet; where symmetry planes do
// not allow that, the nearest from 1.26 to 2.5 that they do.
double draft_ratio(const Case& description);

}  // namespace kerf
