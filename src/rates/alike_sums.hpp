// SPDX-License-Identifier: Apache-2.0
// Sums over the neighbours of a particle's own kind (lanes/packed_fluid.hpp), as the terms of the
// general walk take them up: those of a block of particles, worked out just before it.
#pragma once

#include "lanes/packed_fluid.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class Real>
struct AlikeSums {
  const FluidSums<D, Real>* of_block = nullptr;  // null: the general walk sees all neighbours
  Index first = 0;                               // particle of the block

  KERF_FUNCTION bool are_known() const { return of_block != nullptr; }
  KERF_FUNCTION const FluidSums<D, Real>& operator[](Index i) const { return of_block[i - first]; }
};

}  // namespace kerf
