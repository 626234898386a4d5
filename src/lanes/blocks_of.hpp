// SPDX-License-Identifier: Apache-2.0
// The neighbours of one particle, as many at a time as a register holds.
#pragma once

#include <cstdint>

#include "lanes/lane_numbers.hpp"

// One namespace for each instruction set: the linker must never take the code of one for another.
namespace kerf::lanes::KERF_LANES {

struct Neighbours {
  const std::uint32_t* list;
  std::uint32_t begin, end;  // in the list
};

// The first `left` of the indices, and `self` in the other lanes.
template <int width>
[[gnu::always_inline]] inline void fill_up(const std::uint32_t* indices, int left,
                                           std::uint32_t self, std::uint32_t* filled) {
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

// body(indices, k, count) for each block, whose first `count` entries stand at k in the list. The
// last block is filled up with the particle itself.
template <int width, class Body>
[[gnu::always_inline]] inline void for_each_block(const Neighbours& of, std::uint32_t self,
                                                  const Body& body) {
  for (std::uint32_t k = of.begin; k < of.end; k += width) {
    const std::uint32_t* indices = of.list + k;
    alignas(64) std::uint32_t last[width];
    const auto left = static_cast<int>(of.end - k);
    if (left < width) {
      fill_up<width>(indices, left, self, last);
      indices = last;
    }
    body(indices, k, left < width ? left : width);
  }
}

}  // namespace kerf::lanes::KERF_LANES
