// SPDX-License-Identifier: Apache-2.0
// Lists that lie anywhere in their memory keep their entries when it is compacted.
#include "neighbours/compact_lists.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kerf::test {
namespace {

// Blocks of lists in random order, with gaps between them; some blocks have no entries.
struct ScatteredLists {
  static constexpr Index length = 4, count = 4 * 50 + 3;  // the last block is shorter

  ListBlocks blocks{count, length};
  std::vector<Index> begin, end, capacity, neighbour;
  std::vector<std::vector<Index>> lists;

  explicit ScatteredLists(unsigned seed)
      : begin(count), end(count), capacity(blocks.number()), lists(count), engine_(seed) {
    std::vector<Index> order(blocks.number());
    std::iota(order.begin(), order.end(), Index(0));
    std::shuffle(order.begin(), order.end(), engine_);
    for (const Index block : order) {
      add_unused(9);
      if (engine_() % 5 != 0) add(block);
    }
  }

  Index compact() {
    const ListRanges ranges{begin.data(), end.data(), nullptr, nullptr, nullptr, nullptr};
    std::atomic<Index> none = 0;
    const auto room = static_cast<Index>(neighbour.size());
    return compact_lists(blocks, ranges, {neighbour.data(), room, &none, capacity.data()});
  }

 private:
  void add_unused(unsigned most) { neighbour.resize(neighbour.size() + engine_() % most, 0); }
  void add(Index block) {
    const std::size_t start = neighbour.size();
    for (Index i = blocks.first(block); i < blocks.last(block); ++i) {
      begin[i] = static_cast<Index>(neighbour.size());
      for (unsigned n = engine_() % 30; n > 0; --n) lists[i].push_back(engine_() % 1000);
      neighbour.insert(neighbour.end(), lists[i].begin(), lists[i].end());
      end[i] = static_cast<Index>(neighbour.size());
    }
    add_unused(3);  // spare
    capacity[block] = static_cast<Index>(neighbour.size() - start);
  }

  std::mt19937 engine_;
};

TEST(CompactLists, KeepsEveryEntry) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    ScatteredLists all(seed);
    const Index used = all.compact();
    std::size_t entries = 0;
    std::vector<int> taken(used);
    for (Index i = 0; i < ScatteredLists::count; ++i) {
      const Index begin = all.begin[i], end = all.end[i];
      ASSERT_LE(end, used);
      EXPECT_EQ(std::vector<Index>(all.neighbour.begin() + begin, all.neighbour.begin() + end),
                all.lists[i]);
      for (Index k = begin; k < end; ++k) EXPECT_EQ(taken[k]++, 0);
      entries += all.lists[i].size();
    }
    EXPECT_GE(used, entries);
    EXPECT_LE(used, entries + entries / 16);
  }
}

}  // namespace
}  // namespace kerf::test
