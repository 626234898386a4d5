// SPDX-License-Identifier: Apache-2.0
// Sums over groups have the same bits for any number of threads and any order of the groups.
#include "parallel/group_sum.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <cmath>
#include <numeric>
#include <random>

namespace kerf {
namespace {

struct NumberAndLargest : Terms<2> {
  double largest = 0.0;

  static NumberAndLargest zero() { return {Terms<2>::zero(), 0.0}; }
  void join(const NumberAndLargest& other) {
    Terms<2>::join(other);
    largest = std::max(largest, other.largest);
  }
};

struct AddNumber {
  const double* number;
  void add(Index i, NumberAndLargest& sum) const {
    sum.value[0] += number[i];
    sum.value[1] += 1.0;
    sum.largest = std::max(sum.largest, number[i]);
  }
};

class GroupSums : public testing::Test {
 protected:
  ~GroupSums() override { set_threads(0); }

  static NumberAndLargest sum_on(int threads, const std::vector<std::vector<double>>& groups) {
    std::vector<double> numbers;
    std::vector<Index> begin{0};
    for (const auto& group : groups) {
      numbers.insert(numbers.end(), group.begin(), group.end());
      begin.push_back(static_cast<Index>(numbers.size()));
    }
    set_threads(threads);
    return tbb::task_arena(threads).execute([&] {
      GroupSum<NumberAndLargest> sum;
      const GroupView view{begin.data(), static_cast<Index>(groups.size())};
      return sum(view, begin.back(), AddNumber{numbers.data()});
    });
  }
};

TEST_F(GroupSums, DependNeitherOnThreadsNorOnTheOrderOfGroups) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> sign(-1.0, 1.0), power(-12.0, 8.0);
  for (const std::size_t count : {1u, 15u, 16u, 17u, 1500u, 5000u}) {
    std::vector<std::vector<double>> groups(count);
    long double exact = 0.0L, scale = 0.0L;
    double largest = 0.0;
    std::size_t members = 0;
    for (auto& group : groups) {
      group.resize(1 + engine() % 40);
      members += group.size();
      for (double& x : group) {
        x = sign(engine) * std::pow(10.0, power(engine));
        exact += x;
        scale += std::fabs(x);
        largest = std::max(largest, x);
      }
    }
    const auto one = sum_on(1, groups);
    EXPECT_EQ(one.value[1], static_cast<double>(members));
    EXPECT_EQ(one.largest, largest);
    EXPECT_LE(std::fabs(static_cast<long double>(one.value[0]) - exact), 1e-15L * scale);
    for (const int threads : {1, 2, 3, 7}) {
      std::shuffle(groups.begin(), groups.end(), engine);
      const auto other = sum_on(threads, groups);
      EXPECT_EQ(other.value[0], one.value[0]) << count << " on " << threads;
      EXPECT_EQ(other.value[1], one.value[1]);
      EXPECT_EQ(other.largest, one.largest);
    }
  }
}

// The scratch memory of a long sum must not affect a shorter one.
TEST_F(GroupSums, ShortSumAfterALongOne) {
  const std::vector<double> ones(5000, 1.0);
  std::vector<Index> begin(ones.size() + 1);
  std::iota(begin.begin(), begin.end(), Index(0));
  GroupSum<NumberAndLargest> sum;
  for (const Index count : {5000u, 17u, 1u, 0u})
    EXPECT_EQ(sum({begin.data(), count}, count, AddNumber{ones.data()}).value[0], double(count));
}

}  // namespace
}  // namespace kerf
