// SPDX-License-Identifier: Apache-2.0
// search() tests the candidates of a particle for the neighbour list, 16 at a time with AVX-512,
// else one by one. It is compiled once for each instruction set.
#pragma once

#include "core/simd_numbers.hpp"
#include "neighbours/simd/packed_search.hpp"

namespace kerf::simd::KERF_SIMD {

#if defined(__AVX512F__)
// Tests 16 candidates at a time. What is the same for all of them is copied into members, since the
// compiler must assume that writing the lists changes the task.
template <int D>
class SearchOfParticle {
 public:
  explicit SearchOfParticle(const SearchTask<D>& task)
      : limit_squared_(_mm512_set1_ps(task.limit_squared)),
        same_squared_(_mm512_set1_ps(task.same_squared)),
        own_(_mm512_set1_epi32(static_cast<int>(task.own))),
        own_kind_(_mm512_set1_epi32(static_cast<int>(task.own_kind))),
        kind_(task.kind),
        same_(task.same),
        others_(task.others) {
    for (int a = 0; a < D; ++a) {
      own_position_[a] = _mm512_set1_epi32(task.own_position[a]);
      position_[a] = task.position[a];
    }
  }

  // Tests the candidates from `first` on, of which `left` are in the row.
  [[gnu::always_inline]] void test(std::uint32_t first, std::uint32_t left) {
    const __mmask16 in_row = left < 16 ? __mmask16((1u << left) - 1u) : __mmask16(0xffff);
    using T = SimdNumbers<float>;
    const auto square = static_cast<__m512>(squared_distance<D, T>([&](int a) KERF_SIMD_BODY {
      return T(_mm512_cvtepi32_ps(
          _mm512_sub_epi32(own_position_[a], _mm512_loadu_si512(position_[a] + first))));
    }));
    const __mmask16 near = _mm512_mask_cmp_ps_mask(in_row, square, limit_squared_, _CMP_LT_OQ);
    const __m512i number =
        _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(first)),
                         _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
    const __mmask16 same_kind =
        _mm512_mask_cmpeq_epi32_mask(near, _mm512_loadu_si512(kind_ + first), own_kind_);
    const __mmask16 close = _mm512_mask_cmp_ps_mask(same_kind, square, same_squared_, _CMP_LT_OQ);
    const __mmask16 same = _mm512_mask_cmpneq_epi32_mask(close, number, own_);
    same_ = append(same_, same, number);
    const __mmask16 others = near & static_cast<__mmask16>(~same_kind);
    if (others != 0) others_ = append(others_, others, number);
  }
  SearchCounts counts(const SearchTask<D>& task) const {
    return {static_cast<std::uint32_t>(same_ - task.same),
            static_cast<std::uint32_t>(others_ - task.others)};
  }

 private:
  [[gnu::always_inline]] static std::uint32_t* append(std::uint32_t* list, __mmask16 which,
                                                      __m512i number) {
    _mm512_storeu_si512(list, _mm512_maskz_compress_epi32(which, number));
    return list + __builtin_popcount(which);
  }

  __m512 limit_squared_, same_squared_;
  __m512i own_position_[D], own_, own_kind_;
  const std::int32_t* position_[D];
  const std::uint32_t* kind_;
  std::uint32_t *same_, *others_;  // where the next ones go
};
#endif

template <int D>
[[gnu::flatten]] SearchCounts search(const SearchTask<D>& task) {
  const SearchRows& rows = *task.rows;
#if defined(__AVX512F__)
  SearchOfParticle<D> search(task);
  for (int row = 0; row < rows.count; ++row)
    for (std::uint32_t j = rows.begin[row]; j < rows.end[row]; j += 16)
      search.test(j, rows.end[row] - j);
  return search.counts(task);
#else
  SearchCounts counts{0, 0};
  for (int row = 0; row < rows.count; ++row) {
    for (std::uint32_t j = rows.begin[row]; j < rows.end[row]; ++j) {
      const auto square = squared_distance<D, float>([&](int a) KERF_SIMD_BODY {
        return static_cast<float>(
            static_cast<std::int32_t>(static_cast<std::uint32_t>(task.own_position[a]) -
                                      static_cast<std::uint32_t>(task.position[a][j])));
      });
      if (!(square < task.limit_squared)) continue;
      if (task.kind[j] != task.own_kind) {
        task.others[counts.others++] = j;
      } else if (square < task.same_squared && j != task.own) {
        task.same[counts.same++] = j;
      }
    }
  }
  return counts;
#endif
}

}  // namespace kerf::simd::KERF_SIMD
