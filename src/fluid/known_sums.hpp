// SPDX-License-Identifier: Apache-2.0
// KnownSums are the sums over the neighbours that the SIMD kernels have visited, for a block of
// particles; the terms of the general pair loop start from them. Where they are not known the
// general pair loop visits all neighbours.
#pragma once

#include "fluid/simd/packed_fluid.hpp"
#include "particles/fields.hpp"
#include "simd/run_in_blocks.hpp"

namespace kerf {

template <int D, class Real>
using KnownSums = BlockResults<FluidSums<D, Real>>;

}  // namespace kerf
