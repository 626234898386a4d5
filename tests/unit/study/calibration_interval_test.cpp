// SPDX-License-Identifier: Apache-2.0
// Calibrations by a metric that depends on the key in a part of the range only.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibrated_depth.hpp"

namespace kerf {
namespace {

using namespace test;

// A key that acts in a part of the range: from 10 J/m2 on something else breaks the block, and the
// metric stays as measured. The measurement is that of 16 J/m2 and tells no more than a lower
// bound.
TEST(CalibrationInterval, RunsBeyondTheRootThatAgreeLengthenTheInterval) {
  CalibrationGoal goal = cut_goal(depth(10.0, 5.0), 0.0);
  goal.uncertainty = 0.05 * goal.measured;
  for (const double shift : {-1e-5, 0.0, 1e-5}) {
    test::SyntheticLaboratory laboratory(
        [&](const Trial& trial) {
          const double at = energy_of(trial);
          const double end = at > 10.0 ? shift * depth(10.0, 5.0) : 0.0;
          return std::map<std::string, double>{
              {"kerf.depth", depth(std::min(at, 10.0), speed_of(trial)) + end}};
        },
        1);
    const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
    ASSERT_EQ(answer.problem, "") << shift;
    EXPECT_TRUE(answer.is_open_above) << shift;
    EXPECT_FALSE(answer.is_open_below) << shift;
    EXPECT_NEAR(answer.high, 100.0, 1e-9) << shift;
    EXPECT_LT(answer.low, 10.0) << shift;
  }
}

// The metric is as measured from 10 J/m2 up to 40 J/m2 and falls from there: the interval ends
// where the runs no longer agree, which the search narrows to its tolerance.
TEST(CalibrationInterval, TheEndOfTheAgreementIsNarrowed) {
  const double energy_of_end = 40.0;
  CalibrationGoal goal = cut_goal(0.0, 0.0);
  goal.most_runs = 24;
  goal.measured = 0.999 * depth(10.0, 5.0);
  goal.uncertainty = 0.05 * goal.measured;
  test::SyntheticLaboratory laboratory(
      [&](const Trial& trial) {
        const double at = energy_of(trial);
        const double flat = at < 10.0 ? at : std::max(10.0, 10.0 * at / energy_of_end);
        const double drop = at < energy_of_end ? 0.0 : 0.3 * goal.measured;
        const double lean = 1.0 - 0.002 * std::log(at / 5.0);
        return std::map<std::string, double>{
            {"kerf.depth", lean * depth(flat, speed_of(trial)) - drop}};
      },
      1);
  const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  EXPECT_FALSE(answer.is_open_above);
  EXPECT_GE(answer.high, energy_of_end);
  EXPECT_LE(std::log(answer.high / energy_of_end), goal.tolerance);
  EXPECT_LE(answer.runs, goal.most_runs + 3);
}

// A run that has exactly the measured value leads the method to steps of rounding errors.
TEST(CalibrationInterval, NoTwoRunsHaveTheSameValueButForRounding) {
  for (const double uncertainty : {0.0, 0.0002}) {
    CalibrationGoal goal = cut_goal(0.003, uncertainty);
    test::SyntheticLaboratory laboratory(
        [](const Trial& trial) {
          const double steps = std::round(4.0 * std::log(energy_of(trial)));
          return std::map<std::string, double>{{"kerf.depth", 0.005 - 0.0002 * steps + 5e-11}};
        },
        1);
    calibrate(goal, 1.0, laboratory);
    std::vector<double> values;
    for (const Trial& trial : laboratory.asked)
      if (speed_of(trial) == 5.0) values.push_back(energy_of(trial));
    std::sort(values.begin(), values.end());
    for (std::size_t i = 1; i < values.size(); ++i)
      EXPECT_GT(std::log(values[i] / values[i - 1]), 0.9e-3 * goal.tolerance) << values[i];
  }
}

}  // namespace
}  // namespace kerf
