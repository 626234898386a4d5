// SPDX-License-Identifier: Apache-2.0
// pad_with_self() pads the last neighbours of a particle to a full register.
#pragma once

#include <cstdint>

#include "core/simd_numbers.hpp"

// Each instruction set has a namespace: the linker must never take the code of one for another.
namespace kerf::simd::KERF_SIMD {

// Sets `filled` to the first `left` indices, and to `self` in the other lanes.
template <int width, class Index>
[[gnu::always_inline]] inline void pad_with_self(const Index* indices, int left, Index self,
                                                 Index* filled) {
#if defined(__AVX512F__)
  if constexpr (width == 16) {
    const auto there = static_cast<__mmask16>((1u << left) - 1u);
    const __m512i selves = _mm512_set1_epi32(static_cast<int>(self));
    _mm512_store_si512(filled, _mm512_mask_loadu_epi32(selves, there, indices));
    return;
  }
#elif defined(__AVX2__)
  if constexpr (width == 8) {
    const __m256i there =
        _mm256_cmpgt_epi32(_mm256_set1_epi32(left), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    const __m256i first = _mm256_maskload_epi32(reinterpret_cast<const int*>(indices), there);
    const __m256i selves = _mm256_set1_epi32(static_cast<int>(self));
    _mm256_store_si256(reinterpret_cast<__m256i*>(filled),
                       _mm256_blendv_epi8(selves, first, there));
    return;
  }
#endif
  for (int lane = 0; lane < width; ++lane) filled[lane] = lane < left ? indices[lane] : self;
}

}  // namespace kerf::simd::KERF_SIMD
