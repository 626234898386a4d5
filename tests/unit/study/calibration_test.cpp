// SPDX-License-Identifier: Apache-2.0
// Calibrations of model functions with known results.
#include "study/searches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "calibrated_depth.hpp"
#include "core/random.hpp"
#include "study/metric_jump.hpp"

namespace kerf {
namespace {

using namespace test;
using testing::HasSubstr;

TEST(Calibration, RecoversTheEnergyAndPredictsAnUnusedMeasurement) {
  for (const double truth : {1.5, 4.0, 13.0, 60.0}) {
    CalibrationGoal goal = cut_goal(0.01, 0.0);
    goal.measured = depth(truth, 5.0);
    test::SyntheticLaboratory laboratory(
        [](const Trial& trial) {
          return std::map<std::string, double>{
              {"kerf.depth", depth(energy_of(trial), speed_of(trial))}};
        },
        2);
    const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
    ASSERT_EQ(answer.problem, "") << truth;
    EXPECT_NEAR(answer.value / truth, 1.0, 0.02);
    EXPECT_LT(answer.low, truth);
    EXPECT_GT(answer.high, truth);
    ASSERT_EQ(answer.predictions.size(), 1u);
    EXPECT_NEAR(answer.predictions[0].value / depth(truth, 8.0), 1.0, 0.02);
    EXPECT_LE(answer.predictions[0].low, depth(truth, 8.0));
    EXPECT_GE(answer.predictions[0].high, depth(truth, 8.0));
    EXPECT_LE(answer.runs, goal.most_runs + 3);
  }
}

// depth ~ Gc^-0.4: two standard uncertainties of 5% of the depth are 25% of Gc.
TEST(Calibration, TheIntervalFollowsFromTheUncertaintyOfWhatWasMeasured) {
  const double truth = 10.0;
  CalibrationGoal goal = cut_goal(0.01, 0.0);
  goal.measured = depth(truth, 5.0);
  goal.uncertainty = 0.05 * goal.measured;
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        return std::map<std::string, double>{
            {"kerf.depth", depth(energy_of(trial), speed_of(trial))}};
      },
      2);
  const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  // The line through curved data has a residual too, which widens the interval.
  EXPECT_GE(std::log(answer.high / answer.value), 0.9 * 0.25);
  EXPECT_LE(std::log(answer.high / answer.value), 1.6 * 0.25);
  EXPECT_NEAR(answer.sensitivity / (-0.4 * goal.measured), 1.0, 0.1);
}

TEST(Calibration, ScatterOfTheRunsIsInTheInterval) {
  int covered = 0;
  constexpr int sets = 40;
  for (std::uint64_t set = 0; set < sets; ++set) {
    CalibrationGoal goal = cut_goal(0.01, 0.0);
    goal.measured = depth(10.0, 5.0);
    test::SyntheticLaboratory laboratory(
        [set](const Trial& trial) {
          const auto n = static_cast<std::uint64_t>(1e6 * energy_of(trial));
          const double noise = 1.0 + 0.05 * (2.0 * random_number(set, n) - 1.0);
          return std::map<std::string, double>{
              {"kerf.depth", noise * depth(energy_of(trial), speed_of(trial))}};
        },
        2);
    const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
    ASSERT_EQ(answer.problem, "");
    covered += answer.low <= 10.0 && 10.0 <= answer.high;
  }
  EXPECT_GE(covered, 36);  // 95% less two standard deviations of such a count
}

TEST(Calibration, RecoversTheEnergyFromAThreshold) {
  // The model cuts from the speed 2 (Gc / 10)^0.5 on: at 3 m/s that is Gc = 22.5.
  const CalibrationGoal goal = calibration_of(
      "metric = \"cut_through\"\ntolerance = 0.03\n[calibrate.at]\n\"jet.jet.speed\" = \"3 "
      "m/s\"\n");
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        const bool cuts = speed_of(trial) >= 2.0 * std::sqrt(energy_of(trial) / 10.0);
        return std::map<std::string, double>{{"cut_through", cuts}};
      },
      2);
  const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  EXPECT_LE(answer.low, 22.5);
  EXPECT_GE(answer.high, 22.5);
  EXPECT_NEAR(answer.value / 22.5, 1.0, 0.05);
}

// A run without cut-through has no time of cut-through and is skipped.
TEST(Calibration, RunsWithoutTheMetricAreSkipped) {
  CalibrationGoal goal = cut_goal(0.01, 0.0);
  goal.measured = depth(6.0, 5.0);
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        std::map<std::string, double> metrics;
        if (energy_of(trial) < 50.0)
          metrics["kerf.depth"] = depth(energy_of(trial), speed_of(trial));
        return metrics;
      },
      2);
  const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  EXPECT_NEAR(answer.value / 6.0, 1.0, 0.02);
  test::SyntheticLaboratory nothing([](const Trial&) { return std::map<std::string, double>(); },
                                    2);
  EXPECT_THAT(calibrate(goal, 1.0, nothing).problem, HasSubstr("fewer than two runs"));
}

// From an energy on the cut is some 4 mm deep; below it a crack parts the block, and nothing of it
// is removed. No energy makes a depth of 2 mm.
TEST(Calibration, AJumpIsTheInterval) {
  for (const double threshold : {1.7, 6.0, 37.0}) {
    CalibrationGoal goal = cut_goal(0.002, 0.0001);
    test::SyntheticLaboratory laboratory(
        [&](const Trial& trial) {
          const double deep = 0.004 - 0.0002 * std::log(energy_of(trial));
          return std::map<std::string, double>{
              {"kerf.depth", energy_of(trial) < threshold ? 0.0 : deep}};
        },
        2);
    const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
    ASSERT_EQ(answer.problem, "") << threshold;
    ASSERT_TRUE(answer.jump.has_value()) << threshold;
    EXPECT_EQ(answer.jump->at_low, 0.0);
    EXPECT_NEAR(answer.jump->at_high, 0.004, 0.001);
    EXPECT_EQ(answer.low, answer.jump->low);
    EXPECT_EQ(answer.high, answer.jump->high);
    EXPECT_LT(answer.low, threshold);
    EXPECT_GE(answer.high, threshold);
    EXPECT_LE(std::log(answer.high / answer.low), goal.tolerance);
    EXPECT_GT(answer.value, answer.low);
    EXPECT_LT(answer.value, answer.high);
    EXPECT_LE(answer.runs, goal.most_runs + 3);
  }
}

// A depth that hardly changes determines its energy poorly; the range is known nevertheless.
TEST(Calibration, TheIntervalIsWithinTheRangeAndWhatTheRunsDeny) {
  CalibrationGoal goal = cut_goal(0.01, 0.002);
  goal.measured = depth(3.0, 5.0);
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        return std::map<std::string, double>{
            {"kerf.depth", depth(energy_of(trial), speed_of(trial))}};
      },
      2);
  for (const double uncertainty : {0.0005, 0.002, 0.008}) {
    goal.uncertainty = uncertainty;
    const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
    ASSERT_EQ(answer.problem, "");
    EXPECT_FALSE(answer.jump.has_value());
    EXPECT_GE(answer.low, 1.0);
    EXPECT_LE(answer.high, 100.0);
    EXPECT_LT(answer.low, 3.0);
    EXPECT_GT(answer.high, 3.0);
  }
}

TEST(Calibration, RunsThatMissEndAnInterval) {
  const MetricByKey runs{{0.0, 9.0}, {1.0, 6.0}, {2.0, 4.0}, {2.1, 3.9}, {3.0, 3.5}, {4.0, 1.0}};
  const Bracket all = supported_interval(runs, 2.05, {-5.0, 9.0}, 3.95, 1.0);
  EXPECT_EQ(all.low, 1.0);
  EXPECT_EQ(all.high, 4.0);
  const Bracket inner = supported_interval(runs, 2.05, {1.9, 2.2}, 3.95, 1.0);
  EXPECT_EQ(inner.low, 1.9);
  EXPECT_EQ(inner.high, 2.2);
}

TEST(Calibration, ReportsAnUnreachableMeasurement) {
  CalibrationGoal goal = cut_goal(0.5, 0.0);
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        return std::map<std::string, double>{{"kerf.depth", depth(energy_of(trial), 5.0)}};
      },
      2);
  EXPECT_THAT(calibrate(goal, 1.0, laboratory).problem, HasSubstr("Widen the range"));
}

TEST(Calibration, ReportsAnInsensitiveMetric) {
  CalibrationGoal goal = cut_goal(0.01, 0.0);
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        const auto n = static_cast<std::uint64_t>(1e6 * energy_of(trial));
        return std::map<std::string, double>{{"kerf.depth", 0.009 + 0.002 * random_number(7, n)}};
      },
      2);
  EXPECT_NE(calibrate(goal, 1.0, laboratory).problem, "");
}

}  // namespace
}  // namespace kerf
