// SPDX-License-Identifier: Apache-2.0
// The last neighbours of a particle, where they are fewer than a register holds.
#pragma once

#include <cstdint>

#include "lanes/lane_numbers.hpp"

// One namespace for each instruction set: the linker must never take the code of one for another.
namespace kerf::lanes::KERF_LANES {

// The first `left` of the indices, and `self` in the other lanes.
template <int width, class Index>
[[gnu::always_inline]] inline void fill_up(const Index* indices, int left, Index self,
                                           Index* filled) {
#if defined(__AVX512F__)
  if constexpr (width == 16) {
    const auto there = static_cast<__mmask16>((1u << left) - 1u);
    const __m512i selves = _mm512_set1_epi32(static_cast<int>(self));
    _mm512_store_si512(filled, _mm512_mask_loadu_epi32(selves, there, indices));
    return;
  }
#endif
  for (int lane = 0; lane < width; ++lane) filled[lane] = lane < left ? indices[lane] : self;
}

}  // namespace kerf::lanes::KERF_LANES
