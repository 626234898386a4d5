// SPDX-License-Identifier: Apache-2.0
// Lists that have become longer are at the end of their memory, and where they were is unused:
// compact_lists() moves all lists to the beginning, block by block in the order of the memory.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "neighbours/list_in_blocks.hpp"

namespace kerf {

// Returns how many entries are used then.
inline Index compact_lists(const ListBlocks& blocks, const ListRanges& ranges,
                           const ListMemory& memory) {
  const auto begin_of = [&](Index block) { return ranges.begin[blocks.first(block)]; };
  std::vector<Index> order(blocks.number());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return begin_of(a) < begin_of(b); });
  // Where several begin at one place, all but one are empty, and nothing is moved upwards.
  Index used = 0;
  for (const Index block : order) {
    const Index first = blocks.first(block), last = blocks.last(block);
    const Index from = ranges.begin[first], entries = ranges.end[last - 1] - from;
    std::copy_n(memory.neighbour + from, entries, memory.neighbour + used);
    for (Index i = first; i < last; ++i) {
      ranges.begin[i] = ranges.begin[i] - from + used;
      ranges.end[i] = ranges.end[i] - from + used;
    }
    memory.capacity[block] = std::min(memory.capacity[block], entries + entries / 16);
    used += memory.capacity[block];
  }
  return used;
}

}  // namespace kerf
