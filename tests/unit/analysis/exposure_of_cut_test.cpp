// SPDX-License-Identifier: Apache-2.0
// The feed of runs in which the workpiece is cut through, also by a crack ahead of the water, on
// made-up fronts.
#include <gtest/gtest.h>

#include <cmath>

#include "feeding.hpp"

namespace kerf {
namespace {

using namespace feeding;

TEST(ExposureOfCut, CutGivesTheGreatestFeed) {
  const auto depth = [](double t) { return std::min(slab_thickness, 100.0 * t); };
  const double cut_time = first_contact + since_contact(1e-4, slab_thickness);
  const auto at = [&](double feed) {
    return exposure_of(feeding_case(feed), front_of(depth, 1.2e-4), summary_from(cut_time)).value();
  };
  EXPECT_TRUE(at(1.0).cuts());
  EXPECT_NEAR(at(1.0).greatest_feed, 10.0, 1e-9);
  EXPECT_NEAR(at(1.0).possible_feed, 30.0, 1e-9);
  EXPECT_EQ(at(1.0).decades(), 0.0);
  EXPECT_EQ(at(1.0).depth, slab_thickness);
  EXPECT_FALSE(at(20.0).cuts());
  EXPECT_TRUE(at(20.0).may_cut());
  EXPECT_FALSE(at(40.0).may_cut());
}

// Water of 30 m/s in a workpiece that a crack parts at the time `cut_time`.
std::vector<CutState> cracked_history(double cut_time) {
  std::vector<CutState> history = front_of([](double t) { return 30.0 * t; }, 4e-4);
  for (CutState& state : history) {
    state.cut_through = state.time >= cut_time;
    state.cut_depth = state.cut_through ? slab_thickness : 0.9 * state.front_depth;
  }
  return history;
}

CutSummary cracked_summary(double cut_time, double share) {
  CutSummary cut = summary_from(cut_time);
  cut.front_share_at_cut = share;
  return cut;
}

// A crack parts the workpiece before the water has come to it, as it enters and as it has passed a
// third: the feed is that of the water while the jet covers a point, and none is certain.
TEST(ExposureOfCut, CrackAheadOfTheWaterIsNoCut) {
  for (const auto& [cut_time, share] :
       {std::pair{0.5 * first_contact, 0.0}, std::pair{1.1 * first_contact, 1e-3},
        std::pair{1.2e-4, 0.33}}) {
    const auto history = cracked_history(cut_time);
    const CutSummary cut = cracked_summary(cut_time, share);
    const auto exposure = exposure_of(feeding_case(1.0), history, cut).value();
    const double passage = slab_thickness / 30.0;
    EXPECT_NEAR(exposure.simulated, passage, 0.01 * passage) << share;
    EXPECT_EQ(exposure.greatest_feed, 0.0) << share;
    EXPECT_NEAR(exposure.possible_feed, 1e-3 / passage, 0.01 * 1e-3 / passage) << share;
    EXPECT_FALSE(exposure.cuts());
    EXPECT_TRUE(exposure.may_cut());
    EXPECT_LE(exposure.depth_low, share * slab_thickness);
    EXPECT_TRUE(std::isnan(exposure.depth));
    EXPECT_FALSE(exposure_of(feeding_case(20.0), history, cut)->may_cut());
  }
}

// A run that ends before the water is through the crack carries its depth on.
TEST(ExposureOfCut, WaterInACrackIsCarriedOn) {
  auto history = cracked_history(first_contact);
  history.resize(history.size() / 2);
  const CutSummary cut = cracked_summary(first_contact, 0.0);
  const auto exposure = exposure_of(feeding_case(1.0), history, cut).value();
  const double possible = 1e-3 * 30.0 / slab_thickness;
  EXPECT_EQ(exposure.greatest_feed, 0.0);
  EXPECT_NEAR(exposure.possible_feed, possible, 0.01 * possible);
  EXPECT_NEAR(exposure.exponent, 1.0, 0.01);
}

// A crack that parts the last third: the cut is that of the water, which comes through later.
TEST(ExposureOfCut, TheCutIsWhereTheWaterIsThrough) {
  const double cut_time = first_contact + since_contact(2.2e-4, 6.6e-3);
  const auto history = cracked_history(cut_time);
  const auto exposure =
      exposure_of(feeding_case(1.0), history, cracked_summary(cut_time, 0.66)).value();
  const double passage = slab_thickness / 30.0;
  EXPECT_NEAR(exposure.greatest_feed, 1e-3 / passage, 0.01 * 1e-3 / passage);
  EXPECT_TRUE(exposure.cuts());
}

// A sheet that the jet presses ahead before it tears may evade a moving nozzle.
TEST(ExposureOfCut, NoFeedIsCertainOfWhatGivesWay) {
  const double cut_time = first_contact + since_contact(1e-4, 3e-3);
  auto history = cracked_history(cut_time);
  for (CutState& state : history) state.front_depth *= 8.0;
  const auto at = [&](double share) {
    CutSummary cut = cracked_summary(cut_time, share);
    cut.greatest_share = 1.05;
    return exposure_of(feeding_case(1.0), history, cut).value();
  };
  EXPECT_GT(at(1.04).greatest_feed, 5.0);
  EXPECT_TRUE(at(1.04).cuts());
  EXPECT_EQ(at(1.06).greatest_feed, 0.0);
  EXPECT_EQ(at(1.06).possible_feed, at(1.04).possible_feed);
  EXPECT_FALSE(at(1.06).cuts());
  EXPECT_TRUE(at(1.06).may_cut());
}

// A front that is said to be faster than water drives one: at most half of its speed in a solid of
// its density.
TEST(ExposureOfCut, NoFrontIsFasterThanWaterDrivesIt) {
  Case description = feeding_case(1.0);
  description.materials.resize(2);
  description.materials[0].density = description.materials[1].density = 1000.0;
  description.jets[0].material = 0;
  Body body;
  body.name = workpiece_name;
  body.material = 1;
  description.bodies.push_back(body);
  const double cut_time = first_contact + 20e-6;  // the water is 2 mm deep at most
  std::vector<CutState> history = front_of([](double) { return slab_thickness; }, 1e-4);
  for (int k = 0; k < 500; ++k) history[k].time = first_contact + (k + 1) * 0.1e-6;
  const auto exposure = exposure_of(description, history, summary_from(cut_time)).value();
  EXPECT_NEAR(exposure.simulated, 10e-6, 1e-9);
  EXPECT_NEAR(exposure.greatest_feed, 1e-3 / 10e-6, 1e-3 * 1e-3 / 10e-6);
}

}  // namespace
}  // namespace kerf
