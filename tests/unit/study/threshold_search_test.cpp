// SPDX-License-Identifier: Apache-2.0
// Searches of model functions with a known threshold.
#include "study/run_table.hpp"
#include "study/searches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "study/bisection.hpp"
#include "study/metrics.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using test::speed_of;
using testing::HasSubstr;

ThresholdGoal threshold_of(const std::string& more) {
  return *test::plan_of("[search]\nkey = \"jet.jet.speed\"\nfrom = \"2 m/s\"\nto = \"5 m/s\"\n" +
                        more)
              .threshold;
}

// The model cuts from a speed on.
test::SyntheticLaboratory cutter(double threshold, int side_by_side) {
  return {[=](const Trial& trial) {
            return std::map<std::string, double>{{"cut_through", speed_of(trial) >= threshold}};
          },
          side_by_side};
}

TEST(ThresholdSearch, FindsTheLeastSpeedWithinFivePercentInEightRuns) {
  const ThresholdGoal goal = threshold_of("find = \"least\"\ntolerance = 0.05\ndraft = 1.0\n");
  for (const int side_by_side : {1, 2, 3})
    for (double threshold = 2.05; threshold < 5.0; threshold += 0.093) {
      auto laboratory = cutter(threshold, side_by_side);
      const ThresholdAnswer answer = find_threshold(goal, {}, laboratory);
      ASSERT_EQ(answer.problem, "") << threshold;
      EXPECT_LT(answer.bracket.low, threshold);
      EXPECT_GE(answer.bracket.high, threshold);
      EXPECT_LE(answer.bracket.half_width(), 0.05 * answer.bracket.middle());
      EXPECT_LE(std::abs(answer.value() - threshold), 0.05 * threshold);
      EXPECT_LE(answer.runs, 8);
      EXPECT_EQ(answer.runs, static_cast<int>(laboratory.asked.size()));
    }
}

// Each step halves the range: log2 of the ratio of widths, and the ends if they are needed.
TEST(ThresholdSearch, SequentialSearchIsABisection) {
  const ThresholdGoal goal = threshold_of("find = \"least\"\ntolerance = 0.01\ndraft = 1.0\n");
  auto laboratory = cutter(3.9123, 1);
  const ThresholdAnswer answer = find_threshold(goal, {}, laboratory);
  const double widths = 3.0 / (2 * 0.01 * 3.9123);
  EXPECT_EQ(answer.runs, static_cast<int>(std::ceil(std::log2(widths))));
  EXPECT_EQ(laboratory.rounds, answer.runs);
}

TEST(ThresholdSearch, ParallelRunsReduceTheRounds) {
  const ThresholdGoal goal = threshold_of("find = \"least\"\ntolerance = 0.01\ndraft = 1.0\n");
  auto one = cutter(3.9123, 1), three = cutter(3.9123, 3);
  find_threshold(goal, {}, one);
  find_threshold(goal, {}, three);
  EXPECT_LE(2 * three.rounds, one.rounds + 1);
}

TEST(ThresholdSearch, FindsTheGreatestTraverseThatStillCuts) {
  const ThresholdGoal goal = threshold_of("find = \"greatest\"\ntolerance = 0.02\ndraft = 1.0\n");
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        return std::map<std::string, double>{{"cut_through", speed_of(trial) <= 3.3}};
      },
      2);
  const ThresholdAnswer answer = find_threshold(goal, {}, laboratory);
  EXPECT_LE(answer.bracket.low, 3.3);
  EXPECT_GT(answer.bracket.high, 3.3);
  EXPECT_LE(answer.bracket.half_width(), 0.02 * 3.4);
}

TEST(ThresholdSearch, SupportsOtherConditions) {
  const ThresholdGoal goal = threshold_of(
      "find = \"least\"\ndraft = 1.0\nwhere = { metric = \"kerf.depth\", at_least = \"10 mm\" }\n");
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        return std::map<std::string, double>{{"kerf.depth", 0.0025 * speed_of(trial)}};
      },
      2);
  const ThresholdAnswer answer = find_threshold(goal, {}, laboratory);
  EXPECT_LT(answer.bracket.low, 4.0);
  EXPECT_GE(answer.bracket.high, 4.0);
}

// The threshold is 3% too high at the spacing of the study and 6% in drafts: within brackets of 5%
// such a change is lost. The interval holds what finer runs would find.
TEST(ThresholdSearch, TheIntervalHoldsTheLimitOfAFinerSpacing) {
  const ThresholdGoal goal = threshold_of("find = \"least\"\ntolerance = 0.05\ndraft = 0.5\n");
  for (double exact = 2.1; exact < 4.6; exact *= 1.03) {
    const auto threshold = [&](double refinement) { return exact * (1.0 + 0.03 / refinement); };
    test::SyntheticLaboratory laboratory(
        [&](const Trial& trial) {
          return std::map<std::string, double>{
              {"cut_through", test::speed_of(trial) >= threshold(trial.refinement)}};
        },
        1);
    const ThresholdAnswer answer = find_threshold(goal, {{}, 0, 1.0}, laboratory);
    ASSERT_EQ(answer.problem, "");
    for (const double finer : {1.0, 2.0, 4.0, 1e9}) {
      EXPECT_LE(answer.stated.low, threshold(finer)) << exact;
      EXPECT_GE(answer.stated.high, threshold(finer)) << exact;
    }
    for (const Bracket& layout : answer.layouts) {
      EXPECT_LE(answer.stated.low, layout.low);
      EXPECT_GE(answer.stated.high, layout.high);
    }
  }
}

// The extrapolation removes an error that is proportional to the spacing, t(d) = t0 + c d.
TEST(ThresholdSearch, CoarseRunsFindTheRegionAndResolutionIsExtrapolated) {
  const ThresholdGoal goal =
      threshold_of("find = \"least\"\ntolerance = 0.005\ndraft = 0.5\nruns = 60\n");
  for (const double change : {-0.3, -0.05, 0.0, 0.05, 0.3}) {
    const double exact = 3.4;
    test::SyntheticLaboratory laboratory(
        [=](const Trial& trial) {
          const double threshold = exact + change / trial.refinement;
          return std::map<std::string, double>{{"cut_through", speed_of(trial) >= threshold}};
        },
        2);
    const ThresholdAnswer answer = find_threshold(goal, {{}, 0, 1.0}, laboratory);
    ASSERT_EQ(answer.problem, "") << change;
    EXPECT_LT(answer.bracket.low, exact + change);
    EXPECT_GE(answer.bracket.high, exact + change);
    // Each middle is within its tolerance, so their difference is within the sum of both.
    const double rounding = 0.005 * (exact + 2 * change + 2 * (exact + change));
    EXPECT_NEAR(answer.extrapolated, exact, rounding);
    EXPECT_LE(answer.stated.low, answer.extrapolated);
    EXPECT_GE(answer.stated.high, answer.extrapolated);
    EXPECT_GT(answer.draft_runs, 0);
    EXPECT_LT(answer.draft_runs, answer.runs);
  }
}

TEST(ThresholdSearch, AccurateCoarseRunsNeedTwoFineRuns) {
  const ThresholdGoal goal = threshold_of("find = \"least\"\ntolerance = 0.05\ndraft = 0.5\n");
  auto laboratory = cutter(3.93, 2);
  const ThresholdAnswer answer = find_threshold(goal, {{}, 0, 1.0}, laboratory);
  EXPECT_EQ(answer.runs - answer.draft_runs, 2);
  EXPECT_LE(answer.runs, 8);
}

TEST(ThresholdSearch, TheBracketContainsTheScatterOfLayouts) {
  const ThresholdGoal goal =
      threshold_of("find = \"least\"\ntolerance = 0.02\ndraft = 1.0\nruns = 60\n");
  ThresholdGoal repeated = goal;
  repeated.repeats = 4;
  const double thresholds[] = {3.5, 3.62, 3.41, 3.55};
  test::SyntheticLaboratory laboratory(
      [&](const Trial& trial) {
        return std::map<std::string, double>{
            {"cut_through", speed_of(trial) >= thresholds[trial.repeat]}};
      },
      2);
  const ThresholdAnswer answer = find_threshold(repeated, {}, laboratory);
  ASSERT_EQ(answer.layouts.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(answer.layouts[i].low, thresholds[i]);
    EXPECT_GE(answer.layouts[i].high, thresholds[i]);
  }
  EXPECT_LT(answer.bracket.low, 3.41);
  EXPECT_GE(answer.bracket.high, 3.62);
}

TEST(ThresholdSearch, AlternatingResultsAreWithinTheBracket) {
  const ThresholdGoal goal =
      threshold_of("find = \"least\"\ntolerance = 0.001\ndraft = 1.0\nruns = 40\n");
  // The model cuts from 3.5 on, not between 3.8 and 4.1, and again from there: eight runs find all
  // three changes.
  test::SyntheticLaboratory laboratory(
      [](const Trial& trial) {
        const double speed = speed_of(trial);
        const bool cuts = speed >= 4.1 || (speed >= 3.5 && speed < 3.8);
        return std::map<std::string, double>{{"cut_through", cuts}};
      },
      8);
  const ThresholdAnswer answer = find_threshold(goal, {}, laboratory);
  EXPECT_LT(answer.bracket.low, 3.5);
  EXPECT_GE(answer.bracket.high, 4.1);
  EXPECT_FALSE(answer.is_within_tolerance);
  EXPECT_TRUE(answer.alternates);
  auto steady = cutter(3.9, 8);
  EXPECT_FALSE(find_threshold(goal, {}, steady).alternates);
}

// A run under a nozzle that stands in place of one that moves has a hole at its end, whatever its
// feed: the exposure tells whether that cuts.
TEST(ThresholdSearch, TheExposureTellsWhetherAFeedCuts) {
  const std::map<std::string, double> holed{
      {"cut_through", 1.0}, {"kerf.through_share", 1.0}, {"kerf.margin", 0.3}};
  for (const Condition& condition : {Condition{}, Condition{"kerf.through_share", 0.95, true}}) {
    auto metrics = holed;
    EXPECT_TRUE(condition.holds(metrics));
    metrics["exposure.cuts"] = 0.0;
    EXPECT_FALSE(condition.holds(metrics));
    EXPECT_LT(condition.margin(metrics), 0.0);
    metrics["exposure.cuts"] = 1.0;
    metrics["cut_through"] = metrics["kerf.through_share"] = 0.0;
    EXPECT_TRUE(condition.holds(metrics));
    EXPECT_GT(condition.margin(metrics), 0.0);
    EXPECT_EQ(cuts(metrics), true);
  }
  EXPECT_EQ(cuts(holed), true);
  EXPECT_FALSE(cuts({}).has_value());
  EXPECT_FALSE(may_cut(holed));
  EXPECT_FALSE(may_cut({{"exposure.cuts", 1.0}, {"exposure.may_cut", 1.0}}));
  EXPECT_FALSE(may_cut({{"exposure.cuts", 0.0}, {"exposure.may_cut", 0.0}}));
  RunRow row;
  row.state = RunState::done;
  row.metrics = {{"cut_through", 1.0}, {"exposure.cuts", 0.0}, {"exposure.may_cut", 1.0}};
  EXPECT_TRUE(may_cut(row.metrics));
  EXPECT_EQ(verdict_words[static_cast<std::size_t>(verdict_of(row))], "may cut");
}

TEST(ThresholdSearch, ReportsARangeWithoutAThreshold) {
  const ThresholdGoal goal = threshold_of("find = \"least\"\n");
  auto always = cutter(1.0, 2), never = cutter(9.0, 2);
  EXPECT_THAT(find_threshold(goal, {}, always).problem,
              testing::AllOf(HasSubstr("holds at jet.jet.speed = 2 m/s"), HasSubstr("Lower it")));
  EXPECT_THAT(
      find_threshold(goal, {}, never).problem,
      testing::AllOf(HasSubstr("does not hold at jet.jet.speed = 5 m/s"), HasSubstr("Raise it")));
}

TEST(ThresholdSearch, AFailedRunStopsTheSearchWithItsError) {
  const ThresholdGoal goal = threshold_of("find = \"least\"\n");
  class Broken : public Laboratory {
   public:
    std::vector<Outcome> run(const std::vector<Trial>& trials) override {
      return std::vector<Outcome>(trials.size(), {"abc", true, "a value is not a number", {}});
    }
    int side_by_side() const override { return 1; }
  } broken;
  try {
    find_threshold(goal, {}, broken);
    FAIL() << "no error";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("run abc failed"), HasSubstr("--retry")));
  }
}

// The first division of 1 to 16 is at 4 by ratios, and at 8.5 by differences.
TEST(Bisection, PartsHaveEqualRatiosOnALogarithmicAxis) {
  std::vector<double> tried;
  const auto verdicts = [&](const std::vector<double>& values) {
    tried.insert(tried.end(), values.begin(), values.end());
    return std::vector<bool>(values.size(), true);
  };
  Bisection(verdicts, {1.0, 16.0}, 1, true).narrow(0.01, 1);
  Bisection(verdicts, {1.0, 16.0}, 1, false).narrow(0.01, 1);
  ASSERT_EQ(tried.size(), 2u);
  EXPECT_NEAR(tried[0], 4.0, 1e-12);
  EXPECT_NEAR(tried[1], 8.5, 1e-12);
}

TEST(Bisection, WidensAWrongInitialBracketOnTheWrongSide) {
  for (const double threshold : {2.1, 2.9, 3.55, 4.2, 4.95}) {
    Bisection bisection(
        [&](const std::vector<double>& values) {
          std::vector<bool> verdicts;
          for (const double value : values) verdicts.push_back(value >= threshold);
          return verdicts;
        },
        {2.0, 5.0}, 100);
    bisection.start_at({3.5, 3.6});
    EXPECT_TRUE(bisection.is_confirmed());
    EXPECT_LT(bisection.bracket().low, threshold);
    EXPECT_GE(bisection.bracket().high, threshold);
  }
}

}  // namespace
}  // namespace kerf
