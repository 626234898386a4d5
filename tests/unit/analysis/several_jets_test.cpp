// SPDX-License-Identifier: Apache-2.0
// The water of several jets: which of them has met the workpiece, and whose front it is.
#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "layout.hpp"

namespace kerf::test::several_jets_test {
namespace {

using namespace layout;

// A second jet like the first, whose water has the next source.
Case case_of_two(int dimension) {
  Case description = make_case(dimension);
  description.jets.push_back(description.jets.front());
  return description;
}

// A frame with a column of water from the nozzle down to `depth`, m, of the jet of this number.
Frame frame_with(const Case& description, double depth, int jet, double time) {
  Frame frame = make_block(description.dimension);
  const std::size_t solids = frame.id.size();
  add_water(frame, description, depth, jet_width);
  for (std::size_t row = solids; row < frame.id.size(); ++row)
    frame.source[row] = static_cast<std::uint16_t>(frame.source[row] + jet);
  frame.time = time;
  return frame;
}

class SeveralJets : public testing::TestWithParam<int> {};

TEST_P(SeveralJets, OnlyWaterOfTheFirstMakesItsFront) {
  const Case description = case_of_two(GetParam());
  CutMonitor monitor(description, make_block(GetParam()));
  EXPECT_EQ(monitor.observe(frame_with(description, 30.0 * mm, 1, 1e-3)).front_depth, 0.0);
  EXPECT_GT(monitor.observe(frame_with(description, 30.0 * mm, 0, 2e-3)).front_depth, 20.0 * mm);
}

TEST_P(SeveralJets, TheFirstIsNotCreditedBeforeItsWaterComes) {
  const Case description = case_of_two(GetParam());
  CutMonitor monitor(description, make_block(GetParam()));
  EXPECT_TRUE(monitor.observe(frame_with(description, 30.0 * mm, 1, 1e-3)).is_touched);
  EXPECT_TRUE(monitor.summary().is_of_other_jet);
  EXPECT_TRUE(std::isnan(monitor.summary().first_touch_time));
  monitor.observe(frame_with(description, 30.0 * mm, 0, 2e-3));
  EXPECT_FALSE(monitor.summary().is_of_other_jet);
  EXPECT_EQ(monitor.summary().first_touch_time, 2e-3);
}

// A first jet that aims beside the block has no workpiece, but its water may meet the block later.
TEST_P(SeveralJets, AFirstJetThatAimsBesideTheSolidIsCreditedWhereItsWaterTouches) {
  Case description = case_of_two(GetParam());
  description.jets.front().position[0] = 1.0;
  CutMonitor monitor(description, make_block(GetParam()));
  monitor.observe(frame_with(description, 30.0 * mm, 1, 1e-3));
  EXPECT_TRUE(monitor.summary().is_of_other_jet);
  Frame frame = frame_with(case_of_two(GetParam()), 30.0 * mm, 0, 2e-3);
  monitor.observe(frame);
  EXPECT_FALSE(monitor.summary().is_of_other_jet);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, SeveralJets, testing::Values(2, 3));

}  // namespace
}  // namespace kerf::test::several_jets_test
