// SPDX-License-Identifier: Apache-2.0
// Calibrations by a metric that depends on the key in a part of the range only.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibrated_depth.hpp"
#include "core/random.hpp"

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

// A measurement of what the runs do themselves, with a time of the cut that scatters: the same
// scatter is in the measured run. The least count is 95% less two standard deviations of it.
struct NoisyCut {
  double scatter;      // s, standard deviation of a run
  double uncertainty;  // s, of the measurement
  double exponent;     // of the time over the energy
  int runs;
  double greatest;  // J/m2, of the range
};

double normal_number(std::uint64_t set, std::uint64_t n) {
  const double share = std::max(1e-12, random_number(set, 2 * n));
  return std::sqrt(-2.0 * std::log(share)) *
         std::cos(2.0 * std::numbers::pi * random_number(set, 2 * n + 1));
}

class CoverageOfCalibration : public testing::TestWithParam<NoisyCut> {};

TEST_P(CoverageOfCalibration, IsThatOfTheStatedProbability) {
  const NoisyCut cut = GetParam();
  constexpr double truth = 10.0;
  const auto time = [&](double at) { return 15e-3 * std::pow(at / truth, cut.exponent); };
  int covered = 0, answered = 0;
  double wide = 0.0;
  constexpr int sets = 200;
  for (std::uint64_t set = 1; set <= sets; ++set) {
    CalibrationGoal goal = calibration_of(
        "metric = \"cut_through_time\"\nmeasured = \"15 ms\"\n[calibrate.at]\n"
        "\"jet.jet.speed\" = \"5 m/s\"\n");
    goal.axis.values = {2.0, cut.greatest};
    goal.most_runs = cut.runs;
    goal.uncertainty = cut.uncertainty;
    goal.measured =
        time(truth) + cut.scatter * normal_number(set, 1) + cut.uncertainty * normal_number(set, 2);
    test::SyntheticLaboratory laboratory(
        [&](const Trial& trial) {
          const double at = energy_of(trial);
          const double noise = normal_number(set, static_cast<std::uint64_t>(1e6 * at));
          return std::map<std::string, double>{
              {"cut_through_time", time(at) + cut.scatter * noise}};
        },
        1);
    const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
    if (!answer.problem.empty()) continue;
    ++answered;
    EXPECT_LE(answer.runs, goal.most_runs);
    covered += answer.low <= truth && truth <= answer.high;
    wide += std::log(answer.high / answer.low) / sets;
  }
  EXPECT_GE(answered, 0.95 * sets);
  EXPECT_GE(covered, 0.95 * answered - 2.0 * std::sqrt(0.05 * 0.95 * sets));
  // What one run and the measurement leave open, to both sides, and not several times that.
  const double least = 4.0 * std::hypot(cut.scatter, cut.uncertainty) / (15e-3 * cut.exponent);
  EXPECT_LE(wide, 2.5 * least) << least;
}

INSTANTIATE_TEST_SUITE_P(Calibration, CoverageOfCalibration,
                         testing::Values(NoisyCut{0.6e-3, 0.3e-3, 0.6, 10, 12.0},
                                         NoisyCut{0.6e-3, 0.3e-3, 0.6, 16, 50.0},
                                         NoisyCut{1e-3, 0.0, 0.6, 10, 25.0},
                                         NoisyCut{1.5e-3, 0.3e-3, 0.6, 10, 50.0},
                                         NoisyCut{0.2e-3, 0.5e-3, 0.4, 12, 50.0}));

// The time of the cut at 15 J/m2 is found although the runs at 17 and 50 J/m2 end before they are
// through: cut_through_time is null there.
TEST(CalibrationInterval, IsFoundBetweenRunsWithTheMetricAndRunsWithout) {
  CalibrationGoal goal = calibration_of(
      "metric = \"cut_through_time\"\nmeasured = \"15 ms\"\n[calibrate.at]\n"
      "\"jet.jet.speed\" = \"5 m/s\"\n");
  goal.axis.values = {2.0, 50.0};
  for (const double end : {17e-3, 14e-3}) {
    test::SyntheticLaboratory laboratory(
        [&](const Trial& trial) {
          const double time = 1e-3 * energy_of(trial);
          std::map<std::string, double> metrics;
          if (time < end) metrics["cut_through_time"] = time;
          return metrics;
        },
        1);
    const CalibrationAnswer answer = calibrate(goal, 1.0, laboratory);
    if (end > goal.measured) {
      ASSERT_EQ(answer.problem, "");
      EXPECT_NEAR(answer.value, 15.0, 0.3);
      EXPECT_LE(answer.low, 15.0);
      EXPECT_GE(answer.high, 15.0);
    } else {
      EXPECT_THAT(answer.problem, testing::AllOf(testing::HasSubstr("is between 2 ms and 13."),
                                                 testing::HasSubstr("15 ms was measured"),
                                                 testing::HasSubstr("17.1 J/m2, 50 J/m2 have no"),
                                                 testing::HasSubstr("a later end"),
                                                 testing::Not(testing::HasSubstr("Widen"))));
    }
  }
}

}  // namespace
}  // namespace kerf
