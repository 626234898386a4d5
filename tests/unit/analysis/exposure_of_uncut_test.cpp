// SPDX-License-Identifier: Apache-2.0
// The feed of runs that end before the workpiece is cut through, and of jets in drops, on made-up
// fronts: no more is said of a feed than the run shows.
#include <gtest/gtest.h>

#include <cmath>

#include "feeding.hpp"

namespace kerf {
namespace {

using namespace feeding;

// The front passes the far face of a workpiece whose cut is a spacing short of it, as that of a
// sheet that stretches ahead of it: whatever the cut, no feed is told, nor denied.
TEST(ExposureOfUncut, AFrontBelowWhatIsNotCutTellsNoFeed) {
  auto history = front_of([](double t) { return 1.5e2 * t; }, 1e-4);
  for (CutState& state : history)
    state.cut_depth = std::min(0.99 * slab_thickness, state.cut_depth);
  for (const double feed : {0.1, 1.0, 20.0, 150.0}) {
    const auto exposure = exposure_of(feeding_case(feed), history, summary_from()).value();
    EXPECT_TRUE(std::isnan(exposure.depth_low) && std::isnan(exposure.depth_high)) << feed;
    EXPECT_TRUE(std::isnan(exposure.greatest_feed) && std::isnan(exposure.possible_feed)) << feed;
    EXPECT_FALSE(exposure.cuts());
    EXPECT_TRUE(exposure.may_cut()) << feed;
  }
  const double cut_time = history.back().time;
  history.back().cut_through = true;
  EXPECT_TRUE(exposure_of(feeding_case(0.1), history, summary_from(cut_time))->cuts());
}

// A front that rests at the end of a run that is shorter than the exposure: its depth is the least,
// and the greatest is not known.
TEST(ExposureOfUncut, AFrontAtRestGivesNoIntervalWithoutWidth) {
  const auto depth = [](double t) { return std::min(3e-3, 60.0 * t); };
  const auto history = front_of(depth, 1e-4);
  const auto at = [&](double feed) {
    return exposure_of(feeding_case(feed), history, summary_from()).value();
  };
  EXPECT_NEAR(at(0.5).depth_low, 3e-3, 1e-9);
  EXPECT_TRUE(std::isnan(at(0.5).depth_high));
  EXPECT_FALSE(at(0.5).cuts());
  EXPECT_TRUE(at(0.5).may_cut());
  EXPECT_FALSE(at(60.0).may_cut()) << "the run covers the exposure of 50 us";
}

// Most of the opening is pushed aside: the depth is carried, and no feed is certain.
TEST(ExposureOfUncut, WhatGivesWayIsCarriedToNoCertainFeed) {
  auto history = front_of([](double t) { return 30.0 * t; }, 1e-4);
  for (CutState& state : history) state.fractured_width = 0.9 * state.kerf_width;
  const auto at = [&](double share) {
    CutSummary cut = summary_from();
    cut.removed_share_at_end = share;
    return exposure_of(feeding_case(0.5), history, cut).value();
  };
  EXPECT_TRUE(at(0.6).cuts());
  EXPECT_GT(at(0.6).greatest_feed, 2.0);
  EXPECT_FALSE(at(0.4).cuts());
  EXPECT_TRUE(at(0.4).may_cut());
  EXPECT_EQ(at(0.4).greatest_feed, 0.0);
  EXPECT_EQ(at(0.4).possible_feed, at(0.6).possible_feed);
  EXPECT_NEAR(at(0.4).depth_low, 3e-3, 1e-9);
}

TEST(ExposureOfUncut, TheSharesAreThoseOfTheLastState) {
  CutState state;
  state.kerf_width = 2e-3;
  state.fractured_width = 0.5e-3;
  EXPECT_EQ(state.removed_share(), 1.0) << "a dent is no opening of a cut";
  state.cut_depth = 1e-3;
  EXPECT_EQ(state.removed_share(), 0.25);
  CutSummary cut = summary_from();
  EXPECT_FALSE(cut.gave_way());
  cut.removed_share_at_end = state.removed_share();
  EXPECT_TRUE(cut.gave_way());
  cut.removed_share_at_end = 1.0;
  cut.front_share_at_end = 1.01;
  EXPECT_TRUE(cut.gave_way());
  cut.cut_through = true;
  EXPECT_FALSE(cut.gave_way()) << "what is cut is judged at its cut";
}

// The water of a jet in drops comes for 0.4 of the time, 90 000 times in a second: at 30 m/s a
// point is exposed to three of its pulses.
TEST(ExposureOfUncut, FewDropsMakeNoFeedCertain) {
  const auto depth = [](double t) { return std::min(slab_thickness, 1000.0 * t); };
  const double cut_time = first_contact + since_contact(1e-5, slab_thickness);
  const auto at = [&](double feed, double duty) {
    Case description = feeding_case(feed);
    description.jets[0].pulse_frequency = 90e3;
    description.jets[0].duty = duty;
    return exposure_of(description, front_of(depth, 1.2e-5), summary_from(cut_time)).value();
  };
  EXPECT_NEAR(at(1.0, 1.0).greatest_feed, 100.0, 1e-6);
  EXPECT_NEAR(at(1.0, 0.4).greatest_feed, 30.0, 1e-9);
  EXPECT_EQ(at(1.0, 0.4).possible_feed, at(1.0, 1.0).possible_feed);
  for (const double feed : {1.0, 29.0, 31.0, 90.0}) {
    EXPECT_TRUE(at(feed, 1.0).cuts()) << feed;
    EXPECT_EQ(at(feed, 0.4).cuts(), feed < 30.0) << feed;
    EXPECT_TRUE(at(feed, 0.4).may_cut()) << feed;
  }
}

}  // namespace
}  // namespace kerf
