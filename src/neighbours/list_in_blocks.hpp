// SPDX-License-Identifier: Apache-2.0
// ListBlock finds the neighbour lists of a block of particles on one thread and copies them to the
// end of the used memory. The memory of a list depends on which block was ready first, its entries
// do not.
#pragma once

#include <algorithm>
#include <atomic>

#include "neighbours/find_neighbours.hpp"

namespace kerf {

// Where each list begins and ends, and how many entries are of a class.
struct ListRanges {
  Index *begin, *end, *same_fluid, *unlike, *same_body, *images;
};

template <int D, class P, class Scheme>
struct ListBlock {
  static constexpr Index length = 64;  // particles

  FindNeighbours<D, P, Scheme> find;
  Index count;
  ListRanges ranges;
  Index* neighbour;  // room for `room` entries
  Index room;
  std::atomic<Index>* used;  // out: number of entries, also where there is no room for all

  void operator()(Index block) const {
    thread_local GrownSections found;
    thread_local SearchMemory memory;
    const Index first = block * length, last = std::min(first + length, count);
    found.start_block();
    memory.forget();
    for (Index i = first; i < last; ++i) {
      ranges.begin[i] = found.start_particle();
      find(i, found, &memory);
      found.end_particle();
      ranges.end[i] = found.size();
      ranges.same_fluid[i] = found.count(PairClass::same_fluid);
      ranges.unlike[i] = found.count(PairClass::unlike);
      ranges.same_body[i] = found.count(PairClass::same_body);
      ranges.images[i] = found.count(PairClass::image);
    }
    const Index at = used->fetch_add(found.size());
    if (at + found.size() > room) return;
    std::copy_n(found.begin(), found.size(), neighbour + at);
    for (Index i = first; i < last; ++i) {
      ranges.begin[i] += at;
      ranges.end[i] += at;
    }
  }
};

}  // namespace kerf
