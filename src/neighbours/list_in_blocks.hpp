// SPDX-License-Identifier: Apache-2.0
// The lists of a block of particles, found once by one thread and then put wherever there is room:
// where in memory a list lies depends on which block was ready first, what it holds does not.
#pragma once

#include <algorithm>
#include <atomic>

#include "neighbours/find_neighbours.hpp"

namespace kerf {

// Where the lists are and what of them is kin; indices into one array.
struct ListPlaces {
  Index *begin, *end, *alike, *own;
};

template <int D, class P, class Scheme>
struct ListBlock {
  static constexpr Index length = 64;  // particles

  FindNeighbours<D, P, Scheme> find;
  Index count;
  ListPlaces places;
  Index* neighbour;  // room for `room` of them
  Index room;
  std::atomic<Index>* used;  // out: how many there are, also where there is no room for them all

  void operator()(Index block) const {
    thread_local GrownSections found;
    thread_local SearchMemory memory;
    const Index first = block * length, last = std::min(first + length, count);
    found.start_block();
    memory.forget();
    for (Index i = first; i < last; ++i) {
      places.begin[i] = found.start_particle();
      find(i, found, &memory);
      found.end_particle();
      places.end[i] = found.size();
      places.alike[i] = found.alike();
      places.own[i] = found.own();
    }
    const Index at = used->fetch_add(found.size());
    if (at + found.size() > room) return;
    std::copy_n(found.begin(), found.size(), neighbour + at);
    for (Index i = first; i < last; ++i) {
      places.begin[i] += at;
      places.end[i] += at;
    }
  }
};

}  // namespace kerf
