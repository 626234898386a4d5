// SPDX-License-Identifier: Apache-2.0
// Optima of model functions with known best settings.
#include "study/searches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "synthetic.hpp"

namespace kerf {
namespace {

using test::speed_of;

OptimumGoal optimum_of(const std::string& more) {
  return *test::plan_of(
              "[vary]\n\"jet.jet.speed\" = { from = \"2 m/s\", to = \"10 m/s\" }\n"
              "\"jet.jet.width\" = { from = \"2 mm\", to = \"10 mm\" }\n[search]\n" +
              more)
              .optimum;
}

double width_of(const Trial& trial) {
  return 1e3 * trial.setting.numbers.at("jet.jet.width");
}

// The model cuts if speed x width >= 25 (m/s, mm); the energy of the cut is speed^3 width, least
// for slow and wide jets: on the hyperbola at width 10, speed 2.5, energy 156.
std::map<std::string, double> cut_by_flow(const Trial& trial, double needed) {
  const double margin = speed_of(trial) * width_of(trial) / needed - 1.0;
  return {{"cut_through", margin >= 0.0 ? 1.0 : 0.0},
          {"kerf.margin", std::min(1.0, margin)},
          {"kerf.specific_energy", std::pow(speed_of(trial), 3) * width_of(trial)}};
}

TEST(OptimumSearch, FindsTheLeastEnergyOnTheEdgeOfCutThrough) {
  const OptimumGoal goal =
      optimum_of("find = \"minimum\"\nmetric = \"kerf.specific_energy\"\ndraft = 1.0\nruns = 60\n");
  test::SyntheticLaboratory laboratory([](const Trial& trial) { return cut_by_flow(trial, 25.0); },
                                       2);
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  const double speed = answer.setting.numbers.at("jet.jet.speed");
  const double width = 1e3 * answer.setting.numbers.at("jet.jet.width");
  EXPECT_GE(speed * width, 25.0);
  EXPECT_NEAR(answer.value / 156.25, 1.0, 0.25);
  EXPECT_LE(answer.runs, 60);
  EXPECT_EQ(answer.runs, static_cast<int>(laboratory.asked.size()));
}

TEST(OptimumSearch, CoarseRunsFindTheRegionAndFineRunsConfirmIt) {
  const OptimumGoal goal =
      optimum_of("find = \"minimum\"\nmetric = \"kerf.specific_energy\"\ndraft = 0.5\nruns = 60\n");
  // Coarse runs cut slightly too easily: their best setting does not cut at the requested
  // resolution.
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) { return cut_by_flow(trial, trial.refinement < 1.0 ? 23.0 : 25.0); },
      2);
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  const double flow =
      1e3 * answer.setting.numbers.at("jet.jet.speed") * answer.setting.numbers.at("jet.jet.width");
  EXPECT_GE(flow, 25.0);
  EXPECT_LE(answer.value, 2.0 * 156.25);
  int fine = 0;
  for (const Trial& trial : laboratory.asked) fine += trial.refinement == 1.0;
  EXPECT_EQ(fine, answer.runs - answer.draft_runs);
  EXPECT_LT(fine, answer.draft_runs);
}

TEST(OptimumSearch, StatesTheExtrapolationToZeroSpacing) {
  const OptimumGoal goal =
      optimum_of("find = \"minimum\"\nmetric = \"kerf.specific_energy\"\ndraft = 0.5\nruns = 40\n");
  // The error is 8% at the spacing of the study, proportional to the spacing: 16% in drafts.
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        auto metrics = cut_by_flow(trial, 25.0);
        metrics["kerf.specific_energy"] *= 1.0 + 0.08 / trial.refinement;
        return metrics;
      },
      2);
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  ASSERT_TRUE(answer.extrapolated.has_value());
  EXPECT_NEAR(*answer.draft_value / answer.value, 1.16 / 1.08, 1e-12);
  EXPECT_NEAR(*answer.extrapolated / answer.value, 1.0 / 1.08, 1e-12);
  EXPECT_EQ(answer.low, *answer.extrapolated);
  EXPECT_EQ(answer.high, answer.value);
}

TEST(OptimumSearch, DoesNotExtrapolateIfCoarseRunsDoNotCut) {
  const OptimumGoal goal =
      optimum_of("find = \"minimum\"\nmetric = \"kerf.specific_energy\"\ndraft = 0.5\nruns = 40\n");
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) { return cut_by_flow(trial, trial.refinement < 1.0 ? 35.0 : 25.0); },
      2);
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  const double flow =
      1e3 * answer.setting.numbers.at("jet.jet.speed") * answer.setting.numbers.at("jet.jet.width");
  EXPECT_LT(flow, 35.0);  // otherwise the test is not significant
  EXPECT_FALSE(answer.extrapolated.has_value());
  EXPECT_EQ(answer.low, answer.value);
}

TEST(OptimumSearch, RequestsNoRunTwice) {
  const OptimumGoal goal =
      optimum_of("find = \"minimum\"\nmetric = \"kerf.specific_energy\"\ndraft = 0.5\nruns = 60\n");
  test::SyntheticLaboratory laboratory([](const Trial& trial) { return cut_by_flow(trial, 25.0); },
                                       2);
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  std::set<std::tuple<double, double, double>> distinct;
  for (const Trial& trial : laboratory.asked)
    distinct.emplace(speed_of(trial), width_of(trial), trial.refinement);
  EXPECT_EQ(distinct.size(), laboratory.asked.size());
  EXPECT_EQ(answer.runs, static_cast<int>(laboratory.asked.size()));
}

TEST(OptimumSearch, FindsAnInteriorMaximum) {
  const OptimumGoal goal = optimum_of(
      "find = \"maximum\"\nmetric = \"kerf.depth\"\ndraft = 1.0\nruns = 60\n"
      "where = { metric = \"front_speed\", at_most = \"9 m/s\" }\n");
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        const double x = speed_of(trial) - 5.2, y = width_of(trial) - 6.6;
        return std::map<std::string, double>{{"kerf.depth", 1.0 - 0.02 * x * x - 0.03 * y * y},
                                             {"front_speed", speed_of(trial)}};
      },
      2);
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  ASSERT_EQ(answer.problem, "");
  EXPECT_NEAR(answer.setting.numbers.at("jet.jet.speed"), 5.2, 0.5);
  EXPECT_NEAR(answer.setting.numbers.at("jet.jet.width"), 6.6e-3, 0.5e-3);
}

TEST(OptimumSearch, ForwardsAStop) {
  const OptimumGoal goal =
      optimum_of("find = \"minimum\"\nmetric = \"kerf.specific_energy\"\ndraft = 1.0\nruns = 60\n");
  struct Stop {};
  int runs = 0;
  test::SyntheticLaboratory laboratory(
      [&](const Trial& trial) {
        if (++runs > 18) throw Stop();  // after the first points, within NLopt
        return cut_by_flow(trial, 25.0);
      },
      2);
  EXPECT_THROW(find_optimum(goal, 1.0, laboratory), Stop);
  EXPECT_EQ(runs, 19);
}

TEST(OptimumSearch, ReportsThatNoRunCuts) {
  const OptimumGoal goal =
      optimum_of("find = \"minimum\"\nmetric = \"kerf.specific_energy\"\nruns = 20\n");
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) { return cut_by_flow(trial, 1000.0); }, 2);
  EXPECT_THAT(find_optimum(goal, 1.0, laboratory).problem,
              testing::HasSubstr("cut-through held in none"));
}

}  // namespace
}  // namespace kerf
