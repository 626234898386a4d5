// SPDX-License-Identifier: Apache-2.0
// These types take the neighbours that a search finds for a particle, class by class. Each has
//   Index* room(PairClass, Index most)   returns where the next ones of a class go; null: they are
//                                        counted only,
//   void took(PairClass, Index count)    is called once so many have been written there.
#pragma once

#include <algorithm>
#include <vector>

#include "neighbours/pair_range.hpp"

namespace kerf {

inline constexpr int pair_classes = 5;
inline constexpr Index room_beside = 16;  // entries that may be written past the last one

struct CountedSections {
  Index count[pair_classes] = {};

  KERF_FUNCTION Index* room(PairClass, Index) { return nullptr; }
  KERF_FUNCTION void took(PairClass pair_class, Index more) {
    count[static_cast<int>(pair_class)] += more;
  }
};

// Writes into the list itself, at positions from earlier counts; nothing may be written past the
// last entry.
struct PlacedSections {
  Index* next[pair_classes];

  KERF_FUNCTION Index* room(PairClass pair_class, Index) {
    return next[static_cast<int>(pair_class)];
  }
  KERF_FUNCTION void took(PairClass pair_class, Index more) {
    next[static_cast<int>(pair_class)] += more;
  }
};

// Writes into lists of one thread that grow: those of one particle after another, each in the order
// of a neighbour list.
class GrownSections {
 public:
  void start_block() { size_of(PairClass::same_fluid) = 0; }
  // Returns where the list of the particle begins, counted from the start of the block.
  Index start_particle() {
    for (const PairClass later : in_order_) size_of(later) = 0;
    return begin_ = size();
  }
  Index* room(PairClass pair_class, Index most) {
    std::vector<Index>& list = list_of(pair_class);
    const std::size_t wanted = std::size_t(size_of(pair_class)) + most + room_beside;
    if (list.size() < wanted) list.resize(wanted + wanted / 2);
    return list.data() + size_of(pair_class);
  }
  void took(PairClass pair_class, Index more) { size_of(pair_class) += more; }
  // Appends the whole list of a particle.
  void append_list(const Index* list, Index count) {
    std::copy_n(list, count, room(PairClass::same_fluid, count));
    took(PairClass::same_fluid, count);
  }
  // Joins the sections of the particle.
  void end_particle() {
    same_fluid_ = size() - begin_;
    for (const PairClass later : in_order_) append(later);
  }
  // Returns how many neighbours of a class the particle has.
  Index count(PairClass pair_class) const {
    return pair_class == PairClass::same_fluid ? same_fluid_ : size_[number(pair_class)];
  }
  const Index* begin() const { return list_[number(PairClass::same_fluid)].data(); }
  Index size() const { return size_[number(PairClass::same_fluid)]; }

 private:
  static int number(PairClass pair_class) { return static_cast<int>(pair_class); }
  std::vector<Index>& list_of(PairClass pair_class) { return list_[number(pair_class)]; }
  Index& size_of(PairClass pair_class) { return size_[number(pair_class)]; }
  void append(PairClass pair_class) {
    const Index count = size_of(pair_class);
    if (count == 0) return;
    Index* const to = room(PairClass::same_fluid, count);
    for (Index n = 0; n < count; ++n) to[n] = list_of(pair_class)[n];
    size_of(PairClass::same_fluid) += count;
  }

  // Those after the same fluid.
  static constexpr PairClass in_order_[] = {PairClass::unlike, PairClass::same_body,
                                            PairClass::other, PairClass::image};
  // By class; that of the same fluid holds the joined lists as well.
  std::vector<Index> list_[pair_classes];
  Index size_[pair_classes] = {};
  Index begin_ = 0, same_fluid_ = 0;
};

}  // namespace kerf
