// SPDX-License-Identifier: Apache-2.0
#include "output/background.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace kerf {
namespace {

TEST(Background, ReturnsBeforeTheWorkEnds) {
  std::promise<void> gate;
  std::atomic<bool> is_done = false;
  Background background;
  background.submit([&, open = gate.get_future().share()] {
    open.wait();
    is_done = true;
  });
  EXPECT_FALSE(is_done);
  gate.set_value();
  background.wait();
  EXPECT_TRUE(is_done);
}

TEST(Background, RunsJobsInOrderOneAtATime) {
  std::vector<int> order;
  std::atomic<int> at_work = 0;
  bool was_alone = true;
  Background background;
  for (int i = 0; i < 20; ++i)
    background.submit([&, i] {
      was_alone = was_alone && ++at_work == 1;
      std::this_thread::sleep_for(std::chrono::microseconds(100 * (i % 3)));
      order.push_back(i);
      --at_work;
    });
  background.wait();
  EXPECT_TRUE(was_alone);
  ASSERT_EQ(order.size(), 20u);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(Background, RethrowsAnExceptionOfTheWorkOnce) {
  Background background;
  bool is_next_done = false;
  background.submit([] { throw std::runtime_error("no space"); });
  EXPECT_THROW(background.submit([&] { is_next_done = true; }), std::runtime_error);
  background.wait();
  EXPECT_FALSE(is_next_done);
  background.submit([&] { is_next_done = true; });
  background.wait();
  EXPECT_TRUE(is_next_done);
}

TEST(Background, DestructorWaitsForTheWork) {
  bool is_done = false;
  {
    Background background;
    background.submit([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      is_done = true;
    });
  }
  EXPECT_TRUE(is_done);
}

}  // namespace
}  // namespace kerf
