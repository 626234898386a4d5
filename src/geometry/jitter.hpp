// SPDX-License-Identifier: Apache-2.0
// jitter() displaces the particles of a body from their lattice, so that cracks have no preferred
// directions (docs/theory/layout.md). Each particle moves by up to `jitter` spacings along every
// axis, by a random number that depends on its index. Then the layout is relaxed in ten steps
// against the concentration gradient, relative to that of the lattice,
//   x_i -= 0.2 h^2 sum_j V (grad W_ij - grad W_ij of the lattice),
// with the same bound on the displacement, which equalises the volumes. A particle does not move
// along an axis on which the body ends within a spacing: surfaces are unchanged, and every particle
// keeps its volume.
#pragma once

#include <vector>

#include "model/point.hpp"

namespace kerf {

struct Body;

// `nodes`: positions of the lattice nodes inside the shape, in order, m; replaced by the jittered
// ones.
void jitter(const Body& body, int dimension, std::vector<Point>& nodes);

}  // namespace kerf
