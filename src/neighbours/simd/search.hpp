// SPDX-License-Identifier: Apache-2.0
// search() tests the candidates of a particle for the neighbour list, 16 at a time with AVX-512, 8
// with AVX2, else one by one. It is compiled once for each instruction set.
#pragma once

#include "core/simd_numbers.hpp"
#include "neighbours/simd/packed_search.hpp"
#include "neighbours/simd/search_lanes.hpp"

namespace kerf::simd::KERF_SIMD {

#if defined(__AVX2__)
// Tests a register of candidates at a time. What is the same for all of them is copied into
// members, since the compiler must assume that writing the lists changes the task.
template <int D>
class SearchOfParticle {
 public:
  using Lanes = SearchLanes;

  explicit SearchOfParticle(const SearchTask<D>& task)
      : limit_squared_(task.limit_squared),
        same_squared_(task.same_squared),
        own_(Lanes::filled(task.own)),
        own_kind_(Lanes::filled(task.own_kind)),
        kind_(task.kind),
        same_(task.same),
        others_(task.others) {
    for (int a = 0; a < D; ++a) {
      own_position_[a] = Lanes::filled(static_cast<std::uint32_t>(task.own_position[a]));
      position_[a] = task.position[a];
    }
  }

  // Tests the candidates from `first` on, of which `left` are in the row.
  [[gnu::always_inline]] void test(std::uint32_t first, std::uint32_t left) {
    using T = SimdNumbers<float>;
    using Set = Lanes::Set;
    const Set in_row = Lanes::first(left);
    const T square = squared_distance<D, T>([&](int a) KERF_SIMD_BODY {
      return Lanes::difference(own_position_[a], Lanes::load(position_[a] + first));
    });
    const auto number = Lanes::numbered(first);
    const Set near = Lanes::less(in_row, square, limit_squared_);
    const Set same_kind = Lanes::equal(near, Lanes::load(kind_ + first), own_kind_);
    const Set close = Lanes::less(same_kind, square, same_squared_);
    same_ = Lanes::append(same_, Lanes::unequal(close, number, own_), number);
    const Set others = near & static_cast<Set>(~same_kind);
    if (others != 0) others_ = Lanes::append(others_, others, number);
  }
  SearchCounts counts(const SearchTask<D>& task) const {
    return {static_cast<std::uint32_t>(same_ - task.same),
            static_cast<std::uint32_t>(others_ - task.others)};
  }

 private:
  SimdNumbers<float> limit_squared_, same_squared_;
  Lanes::Integers own_position_[D], own_, own_kind_;
  const std::int32_t* position_[D];
  const std::uint32_t* kind_;
  std::uint32_t *same_, *others_;  // where the next ones go
};
#endif

template <int D>
[[gnu::flatten]] SearchCounts search(const SearchTask<D>& task) {
  const SearchRows& rows = *task.rows;
#if defined(__AVX2__)
  SearchOfParticle<D> search(task);
  for (int row = 0; row < rows.count; ++row)
    for (std::uint32_t j = rows.begin[row]; j < rows.end[row]; j += SearchLanes::width)
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
