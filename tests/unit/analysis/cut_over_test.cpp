// SPDX-License-Identifier: Apache-2.0
// A run ends early once its cut has given the answer.
#include "analysis/cut_over.hpp"

#include <gtest/gtest.h>

#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

CutState state_at(double time, bool cut_through, double depth = 0.0) {
  CutState state;
  state.time = time;
  state.cut_through = cut_through;
  state.front_depth = depth;
  return state;
}

TEST(CutOver, AfterTheTimeThatFollowsTheCut) {
  Case description;
  EXPECT_FALSE(may_end_early(description));
  EXPECT_FALSE(is_cut_over(description, {state_at(1.0, true)}, 100.0));
  description.time.after_cut = 0.5;
  EXPECT_TRUE(may_end_early(description));
  EXPECT_FALSE(is_cut_over(description, {}, 100.0));
  EXPECT_FALSE(is_cut_over(description, {state_at(1.0, false)}, 100.0));
  // The time counts from the first cut, not from the last state.
  const std::vector<CutState> history{state_at(1.0, false), state_at(2.0, true),
                                      state_at(2.4, true)};
  EXPECT_FALSE(is_cut_over(description, history, 2.49));
  EXPECT_TRUE(is_cut_over(description, history, 2.5));
  // What parts and closes again has not been cut.
  EXPECT_FALSE(is_cut_over(description, {state_at(2.0, true), state_at(2.6, false)}, 2.6));
}

// A slab 20 mm thick of which the upper part is simulated, under a jet 1 mm wide.
Case slab(double depth) {
  Case description;
  Jet jet;
  jet.width = 1e-3;
  description.jets = {jet};
  description.workpiece.emplace();
  description.workpiece->size = {0.1, 0.02, 0.1};
  description.workpiece->part.minimum = {-0.01, -depth, -0.01};
  description.workpiece->part.maximum = {0.01, 0.0, 0.01};
  description.time.end = 100.0;
  return description;
}

TEST(CutOver, AtTheEndOfTheSimulatedPart) {
  const Case description = slab(8e-3);
  EXPECT_TRUE(may_end_early(description));
  EXPECT_FALSE(is_cut_over(description, {state_at(1.0, false, 5.9e-3)}, 1.0));
  EXPECT_TRUE(is_cut_over(description, {state_at(1.0, false, 6.1e-3)}, 1.0));
}

// Under a nozzle that stands in place of one that moves, the passage of the water tells the feed;
// it may never follow a crack.
TEST(CutOver, AwaitsTheWaterThatTellsTheFeed) {
  Case description = slab(20e-3);
  description.workpiece->spacing = 1e-4;
  description.time.after_cut = 0.5;
  const auto history = [](double at_cut, double last) {
    return std::vector{state_at(1.0, false, 1e-3), state_at(2.0, true, at_cut),
                       state_at(4.0, true, last)};
  };
  EXPECT_TRUE(is_cut_over(description, history(15e-3, 18e-3), 4.0));
  Machine machine;
  machine.traverse_speed = 0.1;
  machine.motion = NozzleMotion::standing;
  description.machine = machine;
  EXPECT_FALSE(is_cut_over(description, history(15e-3, 18e-3), 4.0));
  EXPECT_EQ(expected_end(description, history(15e-3, 18e-3)), description.time.end);
  EXPECT_TRUE(is_cut_over(description, history(15e-3, 19.95e-3), 4.0));
  EXPECT_TRUE(is_cut_over(description, history(5e-3, 6e-3), 4.0));
}

// A front at 1.5 mm/s comes to the end of the part, 6 mm, after 4 s; one at 5 mm/s through 20 mm.
TEST(CutOver, IsExpectedWhereTheFrontGoesOn) {
  Case part = slab(8e-3);
  EXPECT_DOUBLE_EQ(expected_end(part, {}), 100.0);
  EXPECT_DOUBLE_EQ(expected_end(part, {state_at(1.0, false)}), 100.0);
  EXPECT_DOUBLE_EQ(expected_end(part, {state_at(1.0, false, 1.5e-3)}), 4.0);
  EXPECT_DOUBLE_EQ(expected_end(part, {state_at(9.0, false, 6.1e-3)}), 9.0);
  part.time.end = 3.0;
  EXPECT_DOUBLE_EQ(expected_end(part, {state_at(1.0, false, 1.5e-3)}), 3.0);
  Case whole = slab(20e-3);
  EXPECT_DOUBLE_EQ(expected_end(whole, {state_at(1.0, false, 5e-3)}), 100.0);
  whole.time.after_cut = 0.5;
  EXPECT_DOUBLE_EQ(expected_end(whole, {state_at(1.0, false, 5e-3)}), 4.5);
  EXPECT_DOUBLE_EQ(expected_end(whole, {state_at(3.8, true, 20e-3), state_at(4.0, true, 20e-3)}),
                   4.3);
}

}  // namespace
}  // namespace kerf
