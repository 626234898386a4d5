// SPDX-License-Identifier: Apache-2.0
// Lists that lie anywhere in their memory keep their entries when it is compacted.
#include "neighbours/compact_lists.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kerf::test {
namespace {

TEST(CompactLists, KeepsEveryEntry) {
  constexpr Index length = 4, count = 4 * 50 + 3;  // the last block is shorter
  const ListBlocks blocks{count, length};
  std::mt19937 engine(1);
  for (int trial = 0; trial < 20; ++trial) {
    // The blocks in random order, with gaps; some without entries.
    std::vector<Index> order(blocks.number()), begin(count), end(count), capacity(blocks.number());
    std::iota(order.begin(), order.end(), Index(0));
    std::shuffle(order.begin(), order.end(), engine);
    std::vector<Index> neighbour;
    std::vector<std::vector<Index>> lists(count);
    for (const Index block : order) {
      neighbour.resize(neighbour.size() + engine() % 9, 0);  // unused
      const std::size_t start = neighbour.size();
      const bool is_empty = engine() % 5 == 0;
      for (Index i = blocks.first(block); i < blocks.last(block); ++i) {
        begin[i] = static_cast<Index>(neighbour.size());
        for (unsigned n = is_empty ? 0 : engine() % 30; n > 0; --n) {
          neighbour.push_back(engine() % 1000);
          lists[i].push_back(neighbour.back());
        }
        end[i] = static_cast<Index>(neighbour.size());
      }
      neighbour.resize(neighbour.size() + engine() % 3, 0);  // spare
      capacity[block] = static_cast<Index>(neighbour.size() - start);
      if (is_empty)
        for (Index i = blocks.first(block); i < blocks.last(block); ++i) begin[i] = end[i] = 0;
    }
    const ListRanges ranges{begin.data(), end.data(), nullptr, nullptr, nullptr, nullptr};
    std::atomic<Index> none = 0;
    const auto room = static_cast<Index>(neighbour.size());
    const Index used =
        compact_lists(blocks, ranges, {neighbour.data(), room, &none, capacity.data()});
    std::size_t entries = 0;
    std::vector<int> taken(used);
    for (Index i = 0; i < count; ++i) {
      entries += lists[i].size();
      ASSERT_LE(end[i], used);
      EXPECT_EQ(std::vector<Index>(neighbour.begin() + begin[i], neighbour.begin() + end[i]),
                lists[i]);
      for (Index k = begin[i]; k < end[i]; ++k) EXPECT_EQ(taken[k]++, 0);
    }
    EXPECT_GE(used, entries);
    EXPECT_LE(used, entries + entries / 16);
  }
}

}  // namespace
}  // namespace kerf::test
