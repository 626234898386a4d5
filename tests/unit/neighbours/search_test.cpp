// SPDX-License-Identifier: Apache-2.0
// The SIMD neighbour search against a plain test of each candidate.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "neighbours/simd/search_kernels.hpp"

namespace kerf::test {
namespace {

// Candidates at random in a box of 200 units, of two kinds.
template <int D>
struct Candidates {
  static constexpr std::uint32_t count = 900, beyond = 32;  // entries that may be read
  std::vector<std::int32_t> position[D];
  std::vector<std::uint32_t> kind;

  explicit Candidates(unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_int_distribution<std::int32_t> place(-100, 100);
    for (auto& component : position)
      for (std::uint32_t n = 0; n < count + beyond; ++n) component.push_back(place(engine));
    for (std::uint32_t n = 0; n < count + beyond; ++n) kind.push_back(place(engine) < 60 ? 1 : 2);
  }
};

template <int D>
void expect_the_near_ones(unsigned seed) {
  const Candidates<D> from(seed);
  SearchRows rows;
  for (std::uint32_t first = 3, length = 0; first + length < from.count; first += length + 2)
    rows.take(first, first + ++length);  // of 1, 2, 3, ... candidates
  std::vector<std::uint32_t> same(rows.candidates + 16), others(rows.candidates + 16);
  SearchTask<D> task{};
  task.kind = from.kind.data();
  task.own = 100;
  task.own_kind = from.kind[task.own];
  task.limit_squared = 90.0f * 90.0f;
  task.same_squared = 60.0f * 60.0f;
  task.rows = &rows;
  task.same = same.data();
  task.others = others.data();
  for (int a = 0; a < D; ++a) {
    task.position[a] = from.position[a].data();
    task.own_position[a] = from.position[a][task.own];
  }
  const SearchCounts found = search_kernels().get<D>()(task);

  std::vector<std::uint32_t> due_same, due_others;
  for (int row = 0; row < rows.count; ++row) {
    for (std::uint32_t j = rows.begin[row]; j < rows.end[row]; ++j) {
      std::int64_t square = 0;
      for (int a = 0; a < D; ++a) {
        const std::int64_t apart = from.position[a][j] - task.own_position[a];
        square += apart * apart;
      }
      if (from.kind[j] != task.own_kind && square < 90 * 90) due_others.push_back(j);
      if (from.kind[j] == task.own_kind && square < 60 * 60 && j != task.own) due_same.push_back(j);
    }
  }
  same.resize(found.same);
  others.resize(found.others);
  EXPECT_EQ(same, due_same);
  EXPECT_EQ(others, due_others);
  EXPECT_GT(due_same.size(), 5u);
  EXPECT_GT(due_others.size(), 5u);
}

TEST(SearchKernel, FindsTheNearOnesInOrder) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    expect_the_near_ones<2>(seed);
    expect_the_near_ones<3>(seed);
  }
}

}  // namespace
}  // namespace kerf::test
