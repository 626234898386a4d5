// SPDX-License-Identifier: Apache-2.0
// IndexShare is the share of a rank of the numbers 0 .. count - 1. Without ranks it is all of them,
// and a loop over it is a plain loop.
#pragma once

#include <algorithm>

#include "parallel/loops.hpp"
#include "parallel/ranks.hpp"

namespace kerf {

struct IndexShare {
  // Shares consist of whole blocks of this length, so that sums over blocks do not depend on them
  // (parallel/ordered_sum.hpp).
  static constexpr Index block = 512;

  Index first = 0, last = 0;
  bool is_part = false;  // of several ranks: whether others have the other numbers

  KERF_FUNCTION Index size() const { return last - first; }
  KERF_FUNCTION bool has(Index i) const { return i - first < last - first; }

  static IndexShare whole(Index count) { return {0, count, false}; }
  // That of one of some ranks; the shares of all follow one another.
  static IndexShare of(Index count, int rank, int ranks) {
    const std::uint64_t blocks = (count + block - 1) / block;
    const auto begin = [&](int number) {
      const std::uint64_t before =
          blocks * static_cast<std::uint64_t>(number) / static_cast<std::uint64_t>(ranks);
      return std::min(count, static_cast<Index>(before * block));
    };
    return {begin(rank), begin(rank + 1), true};
  }
};

// Calls a body with the numbers from `first` on.
template <class Body>
struct FromFirst {
  Index first;
  const Body& body;
  auto operator()(Index k) const { return body(first + k); }
};

template <class Body>
void for_each_index(const IndexShare& share, const Body& body) {
  if constexpr (ranks::exist)
    for_each_index(share.size(), FromFirst<Body>{share.first, body});
  else
    for_each_index(share.last, body);
}

// Combines the values of the share.
template <class T, class Value, class Combine>
T reduce_unordered(const IndexShare& share, const Value& value, T initial, const Combine& combine) {
  if constexpr (ranks::exist)
    return reduce_unordered(share.size(), FromFirst<Value>{share.first, value}, initial, combine);
  else
    return reduce_unordered(share.last, value, initial, combine);
}

}  // namespace kerf
