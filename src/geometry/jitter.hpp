// SPDX-License-Identifier: Apache-2.0
// Takes the particles of a body off their lattice, so that a crack finds no rows to run along
// (docs/theory/layout.md). Each moves by up to `jitter` spacings along every axis, at random by its
// number. Then the layout is relaxed: particles step apart where they stand closer than on the
// lattice,
//   x_i -= 0.2 h^2 sum_j V (grad W_ij - grad W_ij of the lattice),
// ten times, never farther off than that, which evens their volumes out. Along an axis on which
// the body ends within a spacing a particle does not move: surfaces stay where they are, and every
// particle keeps its volume.
#pragma once

#include <vector>

#include "model/case.hpp"

namespace kerf {

// `nodes`: those of the lattice inside the shape, in order.
void jitter(const Body& body, int dimension, std::vector<Point>& nodes);

}  // namespace kerf
