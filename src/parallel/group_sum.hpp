// SPDX-License-Identifier: Apache-2.0
// Sums over groups of particles: the numbers of a group are added in the order of its particles,
// and the sums of the groups exactly (parallel/exact_sum.hpp), so that the result depends neither
// on threads and ranks nor on the order or the place of the groups. On a GPU the sum is that of
// parallel/ordered_sum.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "parallel/exact_sum.hpp"
#include "parallel/ordered_sum.hpp"
#include "parallel/ranks.hpp"

namespace kerf {

// The groups of particles begin[0] .. begin[1] - 1, begin[1] .. begin[2] - 1, and so on.
struct GroupView {
  const Index* begin;
  Index count;  // of groups
};

// Some of the groups, which one thread sums. `Sum` is Terms<N>, or derives from it and has more
// that join() combines in any order.
template <class Sum>
struct GroupSumPiece {
  std::array<ExactSum, Sum::terms> exact;
  Sum rest;

  void clear() {
    for (ExactSum& sum : exact) sum.clear();
    rest = Sum::zero();
  }
  void take(const Sum& group) {
    for (int k = 0; k < Sum::terms; ++k) exact[static_cast<std::size_t>(k)].add(group.value[k]);
    rest.join(group);
  }
  void take(const GroupSumPiece& other) {
    for (std::size_t k = 0; k < exact.size(); ++k) exact[k].add(other.exact[k]);
    rest.join(other.rest);
  }
  Sum result() const {
    Sum sum = rest;
    for (int k = 0; k < Sum::terms; ++k) sum.value[k] = exact[static_cast<std::size_t>(k)].value();
    return sum;
  }
};

// Sums over all ranks.
template <class Sum>
void add_over_ranks(GroupSumPiece<Sum>& piece) {
  if (!ranks::are_several()) return;
  std::vector<ExactSum::Parts> parts;
  for (ExactSum& sum : piece.exact) parts.push_back(sum.parts());
  ranks::add_over_all(parts.front().data(), parts.size() * parts.front().size());
  for (std::size_t k = 0; k < parts.size(); ++k) piece.exact[k] = ExactSum::of(parts[k]);
  if constexpr (sizeof(Sum) > sizeof(Terms<Sum::terms>))
    piece.rest = ranks::combined(piece.rest, [](Sum a, const Sum& b) {
      a.join(b);
      return a;
    });
}

template <class Sum, class Value>
struct SumGroups {
  GroupView groups;
  Index length;  // groups of a piece
  const Value& value;
  GroupSumPiece<Sum>* pieces;

  void operator()(Index number) const {
    GroupSumPiece<Sum>& piece = pieces[number];
    piece.clear();
    const Index last = std::min(groups.count, (number + 1) * length);
    for (Index g = number * length; g < last; ++g) {
      Sum sum = Sum::zero();
      add_range(value, groups.begin[g], groups.begin[g + 1], sum);
      piece.take(sum);
    }
  }
};

// The object keeps its scratch space, so that a sum in a step does not allocate.
template <class Sum>
class GroupSum {
 public:
  // `Value` as of OrderedFold; `count` is the number of all particles of the groups.
  template <class Value>
  Sum operator()(const GroupView& groups, Index count, const Value& value) {
#if defined(__CUDACC__)
    static_cast<void>(groups);
    return OrderedFold<Sum>()(count, value);
#else
    if (count == 0 && !ranks::are_several()) return Sum::zero();
    constexpr Index shortest = 16;  // groups
    const auto most_pieces = static_cast<Index>(4 * thread_count());
    const Index length = std::max(shortest, (groups.count + most_pieces - 1) / most_pieces);
    const Index pieces = (groups.count + length - 1) / length;
    if (pieces_.size() <= pieces) pieces_.resize(pieces + 1);
    pieces_[0].clear();
    for_each_index(pieces, SumGroups<Sum, Value>{groups, length, value, pieces_.data()});
    for (Index k = 1; k < pieces; ++k) pieces_[0].take(pieces_[k]);
    add_over_ranks(pieces_[0]);
    return pieces_[0].result();
#endif
  }

  std::size_t bytes() const {
    return pieces_.size() * sizeof(GroupSumPiece<Sum>);
  }

 private:
  std::vector<GroupSumPiece<Sum>> pieces_;
};

}  // namespace kerf
