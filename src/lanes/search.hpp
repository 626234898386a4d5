// SPDX-License-Identifier: Apache-2.0
// The body of the search of lanes/packed_search.hpp. Compiled once for each instruction set.
#pragma once

#include "lanes/lane_numbers.hpp"
#include "lanes/packed_search.hpp"

namespace kerf::lanes::KERF_LANES {

#if defined(__AVX512F__)
// Sixteen candidates at a time. What is the same for all is kept in registers: lists are written in
// between, which for all the compiler knows might change the task.
template <int D>
class SearchOfOne {
 public:
  explicit SearchOfOne(const SearchTask<D>& task)
      : limit_squared_(_mm512_set1_ps(task.limit_squared)),
        same_squared_(_mm512_set1_ps(task.same_squared)),
        own_(_mm512_set1_epi32(static_cast<int>(task.own))),
        own_kind_(_mm512_set1_epi32(static_cast<int>(task.own_kind))),
        kind_(task.kind),
        same_(task.same),
        others_(task.others) {
    for (int a = 0; a < D; ++a) {
      own_place_[a] = _mm512_set1_epi32(task.own_place[a]);
      place_[a] = task.place[a];
    }
  }

  // From `first`, of which `left` count.
  [[gnu::always_inline]] void look_at(std::uint32_t first, std::uint32_t left) {
    const __mmask16 there = left < 16 ? __mmask16((1u << left) - 1u) : __mmask16(0xffff);
    __m512 square = _mm512_setzero_ps();
    for (int a = 0; a < D; ++a) {
      const __m512i apart = _mm512_sub_epi32(own_place_[a], _mm512_loadu_si512(place_[a] + first));
      const __m512 d = _mm512_cvtepi32_ps(apart);
      square = _mm512_fmadd_ps(d, d, square);
    }
    const __mmask16 near = _mm512_mask_cmp_ps_mask(there, square, limit_squared_, _CMP_LT_OQ);
    const __m512i number =
        _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(first)),
                         _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
    const __mmask16 alike =
        _mm512_mask_cmpeq_epi32_mask(near, _mm512_loadu_si512(kind_ + first), own_kind_);
    const __mmask16 close = _mm512_mask_cmp_ps_mask(alike, square, same_squared_, _CMP_LT_OQ);
    const __mmask16 same = _mm512_mask_cmpneq_epi32_mask(close, number, own_);
    same_ = put(same_, same, number);
    const __mmask16 others = near & static_cast<__mmask16>(~alike);
    if (others != 0) others_ = put(others_, others, number);
  }
  Seen seen(const SearchTask<D>& task) const {
    return {static_cast<std::uint32_t>(same_ - task.same),
            static_cast<std::uint32_t>(others_ - task.others)};
  }

 private:
  [[gnu::always_inline]] static std::uint32_t* put(std::uint32_t* list, __mmask16 which,
                                                   __m512i number) {
    _mm512_storeu_si512(list, _mm512_maskz_compress_epi32(which, number));
    return list + __builtin_popcount(which);
  }

  __m512 limit_squared_, same_squared_;
  __m512i own_place_[D], own_, own_kind_;
  const std::int32_t* place_[D];
  const std::uint32_t* kind_;
  std::uint32_t *same_, *others_;  // where the next ones go
};
#endif

template <int D>
[[gnu::flatten]] Seen search(const SearchTask<D>& task) {
  const SearchRows& rows = *task.rows;
#if defined(__AVX512F__)
  SearchOfOne<D> search(task);
  for (int row = 0; row < rows.count; ++row)
    for (std::uint32_t j = rows.begin[row]; j < rows.end[row]; j += 16)
      search.look_at(j, rows.end[row] - j);
  return search.seen(task);
#else
  Seen seen{0, 0};
  for (int row = 0; row < rows.count; ++row) {
    for (std::uint32_t j = rows.begin[row]; j < rows.end[row]; ++j) {
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
  }
  return seen;
#endif
}

}  // namespace kerf::lanes::KERF_LANES
