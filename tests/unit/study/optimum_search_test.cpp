// SPDX-License-Identifier: Apache-2.0
// Optima of model functions with known best settings.
#include "study/searches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <tuple>

#include "study/optimum_runs.hpp"
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
  EXPECT_LE(answer.low, *answer.extrapolated);
  EXPECT_GE(answer.high, answer.value);
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
  EXPECT_LT(answer.low, answer.value);  // its neighbours
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

OptimumGoal speed_optimum(const std::string& more) {
  return *test::plan_of(
              "[vary]\n\"jet.jet.speed\" = { from = \"2 m/s\", to = \"10 m/s\" }\n[search]\n"
              "find = \"minimum\"\nmetric = \"kerf.specific_energy\"\nruns = 24\n" +
              more)
              .optimum;
}

// The least of the curve is 1 at 4 m/s; with a second valley it is 0.8 at 8.5 m/s.
double valley(double speed, bool has_second) {
  const double first = 1.0 + 0.3 * std::pow(speed - 4.0, 2);
  const double second = 0.8 + 0.9 * std::pow(speed - 8.5, 2);
  return has_second ? std::min(first, second) : first;
}

// Returns a laboratory in which everything cuts, and the energy is that of the valleys.
test::SyntheticLaboratory valleys(bool has_second) {
  return {[=](const Trial& trial) {
            return std::map<std::string, double>{
                {"cut_through", 1.0},
                {"kerf.specific_energy", valley(speed_of(trial), has_second)}};
          },
          2};
}

// Checks an answer against the runs at the resolution of the study.
void expect_best_of(const std::vector<Trial>& asked, const OptimumAnswer& answer, bool has_second) {
  double below = 2.0, above = 10.0, least = 1e9;
  const double best = speed_of({answer.setting, 0, 1.0});
  for (const Trial& trial : asked) {
    if (trial.refinement != 1.0) continue;
    const double speed = speed_of(trial);
    least = std::min(least, valley(speed, has_second));
    if (speed < best - 1e-9) below = std::max(below, speed);
    if (speed > best + 1e-9) above = std::min(above, speed);
  }
  EXPECT_EQ(answer.value, least) << "a run is better than the answer";
  EXPECT_EQ(answer.runs, static_cast<int>(asked.size()));
  ASSERT_EQ(answer.neighbours.size(), 1u);
  EXPECT_NEAR(answer.neighbours[0].low, below, 1e-9);
  EXPECT_NEAR(answer.neighbours[0].high, above, 1e-9);
  EXPECT_LT(answer.low, answer.value);
  EXPECT_GT(answer.high, answer.value);
}

TEST(OptimumSearch, LiesBetweenTheNeighboursOfTheBestRun) {
  for (const char* draft : {"draft = 1.0\n", "draft = 0.5\n"}) {
    const OptimumGoal goal = speed_optimum(draft);
    auto one = valleys(false), two = valleys(true);
    const OptimumAnswer single = find_optimum(goal, 1.0, one);
    expect_best_of(one.asked, single, false);
    EXPECT_LE(single.low, 1.0);
    EXPECT_TRUE(single.others.empty()) << draft;
    // Both valleys were seen, in the runs or the drafts.
    const OptimumAnswer best = find_optimum(goal, 1.0, two);
    expect_best_of(two.asked, best, true);
    ASSERT_FALSE(best.others.empty()) << draft;
    const double other = speed_of({best.others[0].setting, 0, 1.0});
    EXPECT_GT(std::abs(other - speed_of({best.setting, 0, 1.0})), 2.0) << draft;
  }
}

// The first points are best near 4 m/s; the runs that are left go to the other valley.
TEST(OptimumSearch, SpendsTheRunsThatAreLeftOnOtherOptima) {
  const OptimumGoal goal = speed_optimum("draft = 1.0\n");
  auto laboratory = valleys(true);
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  EXPECT_NEAR(speed_of({answer.setting, 0, 1.0}), 8.5, 0.1);
  EXPECT_NEAR(answer.value, 0.8, 0.01);
  EXPECT_LE(answer.runs, goal.most_runs);
}

TEST(OptimumSearch, NamesTheOptimaOfItsRuns) {
  std::vector<TriedSetting> runs;
  const double values[] = {3.0, 2.0, 4.0, 1.0, 1.0, 6.0, 5.0};
  for (const double value : values)
    runs.push_back({{static_cast<double>(runs.size()) / 6.0}, 1.0, value, 0.5});
  const auto optima = local_optima(runs, true);
  ASSERT_EQ(optima.size(), 3u);
  EXPECT_EQ(optima[0].shares, runs[3].shares);
  EXPECT_EQ(optima[1].shares, runs[1].shares);
  EXPECT_EQ(optima[2].shares, runs[6].shares);
  EXPECT_EQ(local_optima(runs, false).size(), 3u);
  // Where the condition does not hold there is no optimum, and the interval reaches to the better
  // run beyond its edge.
  runs[1].margin = -0.5;
  EXPECT_EQ(local_optima(runs, true)[1].shares, runs[0].shares);
  const Bracket interval = between_neighbours(runs[0], runs, true);
  EXPECT_EQ(interval.low, 2.0);
  EXPECT_EQ(interval.high, 3.0);
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
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  EXPECT_THAT(answer.problem, testing::HasSubstr("cut-through held in none of "));
  EXPECT_TRUE(std::isnan(answer.value));
}

TEST(OptimumSearch, ReportsThatNoRunThatCutsHasTheMetric) {
  const OptimumGoal goal = optimum_of("find = \"minimum\"\nmetric = \"kerf.taper\"\nruns = 20\n");
  test::SyntheticLaboratory laboratory([](const Trial& trial) { return cut_by_flow(trial, 25.0); },
                                       2);
  const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
  int cut = 0;
  for (const Trial& trial : laboratory.asked) cut += speed_of(trial) * width_of(trial) >= 25.0;
  ASSERT_GT(cut, 0);
  EXPECT_EQ(answer.problem,
            fmt::format("cut-through held in {} of {} runs, and none of these has kerf.taper. "
                        "Choose another metric",
                        cut, laboratory.asked.size()));
}

}  // namespace
}  // namespace kerf
