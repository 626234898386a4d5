// SPDX-License-Identifier: Apache-2.0
// An estimate of the time step where bodies of unlike materials are joined.
#pragma once

namespace kerf {

struct Body;
struct Case;

// Returns the stable step of a particle at the plane face between two joined bodies, s: the limit
// of solid/joint_limit.hpp with half of the bonds of a full lattice to each body, of the body whose
// step is the shorter one.
double joint_step(const Case& description, const Body& body, const Body& other);

}  // namespace kerf
