// SPDX-License-Identifier: Apache-2.0
// SameFluidSums are the sums over neighbours of the same fluid for a block of particles, from which
// the terms of the general pair loop start. Where they are not known the general pair loop visits
// all neighbours.
#pragma once

#include "fluid/simd/packed_fluid.hpp"
#include "particles/fields.hpp"
#include "simd/run_in_blocks.hpp"

namespace kerf {

template <int D, class Real>
using SameFluidSums = BlockResults<FluidSums<D, Real>>;

}  // namespace kerf
