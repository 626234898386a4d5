// SPDX-License-Identifier: Apache-2.0
// The SIMD kernel of the neighbour search, chosen for this processor.
#pragma once

#include "neighbours/simd/packed_search.hpp"
#include "simd/instruction_set.hpp"

namespace kerf {

struct SearchKernels {
  Search<2> search_2d;
  Search<3> search_3d;

  template <int D>
  Search<D> get() const {
    if constexpr (D == 2) return search_2d;
    if constexpr (D == 3) return search_3d;
  }
};

const SearchKernels& search_kernels();

}  // namespace kerf
