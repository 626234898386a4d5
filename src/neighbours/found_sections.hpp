// SPDX-License-Identifier: Apache-2.0
// Where a search puts the neighbours of a particle, kin by kin. Each has
//   Index* room(Kinship, Index most)   where the next ones of that kinship go; null: only counted,
//   void took(Kinship, Index count)   so many have been put there.
#pragma once

#include <vector>

#include "neighbours/pair_range.hpp"

namespace kerf {

inline constexpr int kinships = 3;
inline constexpr Index room_beside = 16;  // what may be written past the last one

struct CountedSections {
  Index count[kinships] = {};

  KERF_FUNCTION Index* room(Kinship, Index) { return nullptr; }
  KERF_FUNCTION void took(Kinship kin, Index more) { count[static_cast<int>(kin)] += more; }
};

// In the list itself, where counts have left it room; nothing may be written past the last one.
struct PlacedSections {
  Index* next[kinships];

  KERF_FUNCTION Index* room(Kinship kin, Index) { return next[static_cast<int>(kin)]; }
  KERF_FUNCTION void took(Kinship kin, Index more) { next[static_cast<int>(kin)] += more; }
};

// In lists that grow, of one thread: those of one particle after another, each in the order of a
// neighbour list.
class GrownSections {
 public:
  void start_block() { size_ = 0; }
  // Where the lists of the particle begin, from the start of the block on.
  Index start_particle() {
    own_size_ = other_size_ = 0;
    return begin_ = size_;
  }
  Index* room(Kinship kin, Index most) {
    std::vector<Index>& list = list_of(kin);
    const std::size_t wanted = std::size_t(size_of(kin)) + most + room_beside;
    if (list.size() < wanted) list.resize(wanted + wanted / 2);
    return list.data() + size_of(kin);
  }
  void took(Kinship kin, Index more) { size_of(kin) += more; }
  // Puts the sections of the particle one behind the other.
  void end_particle() {
    alike_ = size_ - begin_;
    append(Kinship::own);
    append(Kinship::other);
  }
  Index alike() const { return alike_; }
  Index own() const { return own_size_; }
  const Index* begin() const { return lists_.data(); }
  Index size() const { return size_; }

 private:
  std::vector<Index>& list_of(Kinship kin) {
    return kin == Kinship::alike ? lists_ : kin == Kinship::own ? own_ : other_;
  }
  Index& size_of(Kinship kin) {
    return kin == Kinship::alike ? size_ : kin == Kinship::own ? own_size_ : other_size_;
  }
  void append(Kinship kin) {
    const Index count = size_of(kin);
    if (count == 0) return;
    Index* const to = room(Kinship::alike, count);
    for (Index n = 0; n < count; ++n) to[n] = list_of(kin)[n];
    size_ += count;
  }

  std::vector<Index> lists_, own_, other_;
  Index size_ = 0, own_size_ = 0, other_size_ = 0, begin_ = 0, alike_ = 0;
};

}  // namespace kerf
