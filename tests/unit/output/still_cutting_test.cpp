// SPDX-License-Identifier: Apache-2.0
// Whether a run ended too soon follows from the last tenth of its history.
#include <gtest/gtest.h>

#include <algorithm>

#include "output/result.hpp"

namespace kerf {
namespace {

TEST(StillCutting, TestsTheLastTenth) {
  std::vector<CutState> history(101);
  for (std::size_t i = 0; i < history.size(); ++i) {
    history[i].time = static_cast<double>(i);
    history[i].front_depth = std::min(80.0, static_cast<double>(i));
    history[i].cut_depth = 1.0;
  }
  EXPECT_FALSE(still_cutting(history));
  for (std::size_t i = 0; i < history.size(); ++i) history[i].front_depth = static_cast<double>(i);
  EXPECT_TRUE(still_cutting(history));
  history.back().cut_depth = 0.0;  // a dent
  EXPECT_FALSE(still_cutting(history));
  history.back().cut_depth = 1.0;
  history.back().cut_through = true;
  EXPECT_FALSE(still_cutting(history));
  EXPECT_FALSE(still_cutting({}));
}

// Solid may tear from the far side, where no cut leads from the face.
TEST(StillCutting, TellsSolidThatTearsAtTheEnd) {
  const auto ends = [](double first, double last, bool is_through = false) {
    std::vector<CutState> history(101);
    for (std::size_t i = 0; i < history.size(); ++i) {
      history[i].time = static_cast<double>(i);
      history[i].bodies.resize(2);
      history[i].bodies[1].torn = std::clamp((history[i].time - first) / (last - first), 0.0, 1.0);
    }
    history.back().cut_through = is_through;
    return still_cutting(history);
  };
  EXPECT_TRUE(ends(20.0, 100.0));
  EXPECT_TRUE(ends(93.0, 97.0));
  EXPECT_FALSE(ends(20.0, 89.0));    // it came to rest
  EXPECT_FALSE(ends(200.0, 300.0));  // nothing is torn
  EXPECT_FALSE(ends(20.0, 100.0, true));
}

}  // namespace
}  // namespace kerf
