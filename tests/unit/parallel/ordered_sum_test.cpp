// SPDX-License-Identifier: Apache-2.0
// Loops, reductions and sums have the same bits for any number of threads.
#include "parallel/ordered_sum.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <random>
#include <set>

#include "parallel/threads.hpp"

namespace kerf {
namespace {

struct Entry {
  const double* number;
  void add(Index i, Terms<2>& sum) const {
    sum.value[0] += number[i];
    sum.value[1] += 1.0;
  }
};

struct Fetch {
  const double* number;
  double operator()(Index i) const { return number[i]; }
};

struct Count {
  std::atomic<int>* visits;
  void operator()(Index i) const { ++visits[i]; }
};

// The values are from 1e-8 to 1e8 with both signs, so that the order of a sum matters.
std::vector<double> numbers(std::size_t count) {
  std::mt19937_64 engine(count + 1);
  std::uniform_real_distribution<double> sign(-1.0, 1.0), power(-8.0, 8.0);
  std::vector<double> result(count);
  for (double& x : result) x = sign(engine) * std::pow(10.0, power(engine));
  return result;
}

class AnyThreads : public testing::Test {
 protected:
  ~AnyThreads() override { set_threads(0); }

  // Runs `work` with that number of threads even if there are fewer cores.
  template <class Work>
  static auto with_threads(int threads, const Work& work) {
    set_threads(threads);
    return tbb::task_arena(threads).execute(work);
  }
};

TEST_F(AnyThreads, SumsHaveTheSameBits) {
  for (std::size_t count : {0u, 1u, 511u, 512u, 513u, 1024u, 100003u}) {
    Array<double> device;
    const std::vector<double> host = numbers(count);
    to_device(host, device);
    long double exact = 0.0L, scale = 0.0L;
    for (double x : host) {
      exact += x;
      scale += std::fabs(x);
    }
    OrderedSum<2> sum;
    const auto n = static_cast<Index>(count);
    const auto one = with_threads(1, [&] { return sum(n, Entry{pointer(device)}); });
    EXPECT_EQ(one.value[1], static_cast<double>(count));
    EXPECT_LE(std::fabs(static_cast<long double>(one.value[0]) - exact), 1e-13L * scale);
    for (int threads : {2, 3, 4, 7}) {
      const auto more = with_threads(threads, [&] { return sum(n, Entry{pointer(device)}); });
      EXPECT_EQ(std::memcmp(&one, &more, sizeof(one)), 0) << count << " on " << threads;
    }
  }
}

// The scratch memory of a long sum must not affect a shorter one.
TEST_F(AnyThreads, ShortSumAfterALongOne) {
  Array<double> device;
  to_device(std::vector<double>(5000, 1.0), device);
  OrderedSum<2> sum;
  EXPECT_EQ(sum(5000, Entry{pointer(device)}).value[0], 5000.0);
  EXPECT_EQ(sum(700, Entry{pointer(device)}).value[0], 700.0);
  EXPECT_EQ(sum(0, Entry{pointer(device)}).value[0], 0.0);
}

TEST_F(AnyThreads, ReduceUnordered) {
  for (std::size_t count : {1u, 1000u, 100003u}) {
    Array<double> device;
    const std::vector<double> host = numbers(count);
    to_device(host, device);
    const double least = *std::min_element(host.begin(), host.end());
    const double most = *std::max_element(host.begin(), host.end());
    for (int threads : {1, 2, 3}) {
      with_threads(threads, [&] {
        const auto n = static_cast<Index>(count);
        const Fetch fetch{pointer(device)};
        EXPECT_EQ(reduce_unordered(n, fetch, 1e300, thrust::minimum<double>()), least);
        EXPECT_EQ(reduce_unordered(n, fetch, -1e300, thrust::maximum<double>()), most);
        return 0;
      });
    }
  }
  // An empty reduction returns the initial value.
  EXPECT_EQ(reduce_unordered(0, Fetch{nullptr}, 7.0, thrust::minimum<double>()), 7.0);
}

TEST_F(AnyThreads, EveryIndexOnce) {
  for (int threads : {1, 2, 3}) {
    std::vector<std::atomic<int>> visits(10007);
    with_threads(threads, [&] {
      for_each_index(10007, Count{visits.data()});
      return 0;
    });
    for (const auto& visit : visits) ASSERT_EQ(visit.load(), 1);
  }
}

}  // namespace
}  // namespace kerf
