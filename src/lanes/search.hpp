// SPDX-License-Identifier: Apache-2.0
// The body of the search of lanes/packed_search.hpp. Compiled once for each instruction set.
#pragma once

#include "lanes/lane_numbers.hpp"
#include "lanes/packed_search.hpp"

namespace kerf::lanes::KERF_LANES {

#if defined(__AVX512F__)
// 16 candidates from `first`, of which `left` count.
template <int D>
[[gnu::always_inline]] inline void look_at(const SearchTask<D>& task, std::uint32_t first,
                                           std::uint32_t left, Seen& seen) {
  const __mmask16 there = left < 16 ? __mmask16((1u << left) - 1u) : __mmask16(0xffff);
  __m512 square = _mm512_setzero_ps();
  for (int a = 0; a < D; ++a) {
    const __m512i apart = _mm512_sub_epi32(_mm512_set1_epi32(task.own_place[a]),
                                           _mm512_loadu_si512(task.place[a] + first));
    const __m512 d = _mm512_cvtepi32_ps(apart);
    square = _mm512_fmadd_ps(d, d, square);
  }
  const __m512i number =
      _mm512_add_epi32(_mm512_set1_epi32(int(first)),
                       _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  const __mmask16 near =
      _mm512_mask_cmp_ps_mask(there, square, _mm512_set1_ps(task.limit_squared), _CMP_LT_OQ);
  const __mmask16 alike = _mm512_cmpeq_epi32_mask(_mm512_loadu_si512(task.kind + first),
                                                  _mm512_set1_epi32(int(task.own_kind)));
  const __mmask16 close =
      _mm512_mask_cmp_ps_mask(near & alike, square, _mm512_set1_ps(task.same_squared), _CMP_LT_OQ);
  const __mmask16 same =
      _mm512_mask_cmpneq_epi32_mask(close, number, _mm512_set1_epi32(int(task.own)));
  const auto found = std::uint32_t(__builtin_popcount(same));
  _mm512_storeu_si512(task.same + seen.same, _mm512_maskz_compress_epi32(same, number));
  seen.same += found;
  const __mmask16 others = near & static_cast<__mmask16>(~alike);
  if (others == 0) return;
  _mm512_storeu_si512(task.others + seen.others, _mm512_maskz_compress_epi32(others, number));
  seen.others += std::uint32_t(__builtin_popcount(others));
}
#endif

template <int D>
[[gnu::flatten]] Seen search(const SearchTask<D>& task) {
  Seen seen{0, 0};
  for (int row = 0; row < task.rows->count; ++row) {
    const std::uint32_t end = task.rows->end[row];
#if defined(__AVX512F__)
    for (std::uint32_t j = task.rows->begin[row]; j < end; j += 16) look_at(task, j, end - j, seen);
#else
    for (std::uint32_t j = task.rows->begin[row]; j < end; ++j) {
      float square = 0;
      for (int a = 0; a < D; ++a) {
        const auto d = static_cast<float>(
            static_cast<std::int32_t>(static_cast<std::uint32_t>(task.own_place[a]) -
                                      static_cast<std::uint32_t>(task.place[a][j])));
        square += d * d;
      }
      if (!(square < task.limit_squared)) continue;
      if (task.kind[j] != task.own_kind) {
        task.others[seen.others++] = j;
      } else if (square < task.same_squared && j != task.own) {
        task.same[seen.same++] = j;
      }
    }
#endif
  }
  return seen;
}

}  // namespace kerf::lanes::KERF_LANES
