// SPDX-License-Identifier: Apache-2.0
// These loops build the neighbour lists on a GPU in two passes, one that counts the neighbours and
// one that writes them, since the threads of a GPU have no lists of their own that could grow. Each
// list begins at a multiple of `list_alignment` entries, which a thread loads at once.
#pragma once

#include "neighbours/find_neighbours.hpp"
#include "neighbours/list_in_blocks.hpp"

namespace kerf {

inline constexpr Index list_alignment = 4;

template <int D, class P, class Scheme>
struct CountNeighbours {
  FindNeighbours<D, P, Scheme> find;
  ListRanges ranges;  // `end` gets the count, and `begin` the room that the list takes

  KERF_FUNCTION void operator()(Index i) const {
    CountedSections found;
    find(i, found);
    ranges.same_fluid[i] = found.count[static_cast<int>(PairClass::same_fluid)];
    ranges.unlike[i] = found.count[static_cast<int>(PairClass::unlike)];
    ranges.same_body[i] = found.count[static_cast<int>(PairClass::same_body)];
    ranges.images[i] = found.count[static_cast<int>(PairClass::image)];
    const Index count = ranges.same_fluid[i] + ranges.unlike[i] + ranges.same_body[i] +
                        found.count[static_cast<int>(PairClass::other)] + ranges.images[i];
    ranges.end[i] = count;
    ranges.begin[i] = (count + list_alignment - 1) / list_alignment * list_alignment;
  }
};

template <int D, class P, class Scheme>
struct WriteNeighbours {
  FindNeighbours<D, P, Scheme> find;
  ListRanges ranges;
  Index* neighbour;

  KERF_FUNCTION void operator()(Index i) const {
    ranges.end[i] += ranges.begin[i];
    Index* const same_fluid = neighbour + ranges.begin[i];
    Index* const unlike = same_fluid + ranges.same_fluid[i];
    Index* const same_body = unlike + ranges.unlike[i];
    PlacedSections found;
    found.next[static_cast<int>(PairClass::same_fluid)] = same_fluid;
    found.next[static_cast<int>(PairClass::unlike)] = unlike;
    found.next[static_cast<int>(PairClass::same_body)] = same_body;
    found.next[static_cast<int>(PairClass::other)] = same_body + ranges.same_body[i];
    found.next[static_cast<int>(PairClass::image)] = neighbour + ranges.end[i] - ranges.images[i];
    find(i, found);
  }
};

}  // namespace kerf
