// SPDX-License-Identifier: Apache-2.0
// Sums over the neighbours of a particle's own kind (lanes/packed_fluid.hpp), as the terms of the
// general walk take them up: those of a block of particles, worked out just before it. Where they
// are not known the general walk sees all neighbours.
#pragma once

#include "lanes/packed_fluid.hpp"
#include "lanes/walk_in_blocks.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class Real>
using AlikeSums = BlockResults<FluidSums<D, Real>>;

}  // namespace kerf
