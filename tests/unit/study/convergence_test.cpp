// SPDX-License-Identifier: Apache-2.0
// Intervals from spacings and layouts, against series of known order.
#include "study/convergence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "input/read.hpp"
#include "model/case.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;

// f(d) = f_0 + c d^p at the spacings d, r d, r^2 d, whose error at d is c d^p.
std::vector<double> series_of(double limit, double coefficient, double order, double ratio) {
  std::vector<double> values;
  for (int level = 0; level < 3; ++level)
    values.push_back(limit + coefficient * std::pow(0.3 * std::pow(ratio, level), order));
  return values;
}

TEST(Convergence, RecoversTheOrderAndErrorOfASeries) {
  for (const double order : {0.6, 1.0, 1.5, 2.0})
    for (const double ratio : {1.26, std::sqrt(2.0), 2.0})
      for (const double coefficient : {-1.4, 0.02}) {
        const auto values = series_of(3.0, coefficient, order, ratio);
        const SpacingEffect effect = effect_of_spacing(values, ratio);
        EXPECT_EQ(effect.rule, SpacingRule::grid_convergence);
        EXPECT_NEAR(effect.order, order, 1e-9);
        // Roache's factor of safety for three grids times the true error.
        const double error = std::abs(values[0] - 3.0);
        EXPECT_NEAR(effect.below, 1.25 * error, 1e-9 * error);
        EXPECT_EQ(effect.below, effect.above);
      }
}

// A series of order p is wrong by |e_21| / (r^p - 1): the cautious interval covers it.
TEST(Convergence, IsCautiousWhereTheOrderIsTooHigh) {
  for (const double order : {2.3, 6.0, 12.0}) {
    const auto values = series_of(3.0, 1.0, order, 1.4);
    const SpacingEffect effect = effect_of_spacing(values, 1.4);
    EXPECT_EQ(effect.rule, SpacingRule::limited_order);
    EXPECT_NEAR(effect.order, order, 1e-6);
    EXPECT_NEAR(effect.above, 3.0 * std::abs(values[1] - values[0]) / 0.4, 1e-12);
    EXPECT_GT(effect.above, std::abs(values[0] - 3.0));
  }
}

// Nearly equal changes have an order near 0, by which the error would be without bound. The line
// through 0, 1, 2.1 at h = 1, r, r^2 with r^2 = 2 has the slope 2.0853 and the misses -0.0503,
// 0.0859 and -0.0356; the last change is half of the range, and the effect is three times the
// range.
TEST(Convergence, LimitsAnOrderThatIsTooLow) {
  const double ratio = std::sqrt(2.0);
  const std::vector<double> values{0.0, 1.0, 2.1};
  const SpacingEffect effect = effect_of_spacing(values, ratio);
  EXPECT_EQ(effect.rule, SpacingRule::limited_order);
  EXPECT_NEAR(effect.order, std::log(1.1) / std::log(ratio), 1e-12);
  EXPECT_NEAR(effect.above, 3.0 * 2.0853 + 0.1058 + 0.0503, 1e-3);
  EXPECT_EQ(effect.above, effect.below);
  EXPECT_LT(effect.above, 3.1 * 2.1);
}

TEST(Convergence, TwoSpacingsHaveAFactorOfThree) {
  const auto values = series_of(3.0, 0.5, 1.0, 2.0);
  const SpacingEffect effect = effect_of_spacing(std::span(values).first(2), 2.0);
  EXPECT_EQ(effect.rule, SpacingRule::two_spacings);
  EXPECT_NEAR(effect.above, 3.0 * (values[0] - 3.0), 1e-12);
  EXPECT_TRUE(std::isnan(effect.order));
}

TEST(Convergence, SequencesThatDoNotConvergeHaveTheirRange) {
  for (const std::vector<double>& values :
       {std::vector{1.48, 3.47, 2.0}, std::vector{1.0, 2.0, 2.5}, std::vector{2.0, 2.0, 3.0},
        std::vector{1.0, 2.0, 2.0}}) {
    const SpacingEffect effect = effect_of_spacing(values, 1.4);
    EXPECT_EQ(effect.rule, SpacingRule::range);
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    EXPECT_DOUBLE_EQ(effect.below, *greatest - *least);
    EXPECT_DOUBLE_EQ(effect.above, *greatest - *least);
  }
  const std::vector<double> constant{2.0, 2.0, 2.0}, one{2.0};
  EXPECT_EQ(effect_of_spacing(constant, 1.4).rule, SpacingRule::constant);
  EXPECT_EQ(effect_of_spacing(constant, 1.4).above, 0.0);
  EXPECT_EQ(effect_of_spacing(one, 1.4).rule, SpacingRule::unknown);
}

// A made-up run: the depth is of first order in the spacing and differs by layout.
Outcome made_up(const Trial& trial, bool cuts) {
  static constexpr double by_layout[] = {0.0, 2e-4, -1e-4};
  Outcome outcome;
  outcome.metrics = {{"kerf.depth", 4e-3 + 1e-3 / trial.refinement + by_layout[trial.repeat]},
                     {"cut_through", cuts}};
  if (cuts) outcome.metrics["cut_through_time"] = 5e-3;
  return outcome;
}

TEST(Convergence, CombinesSpacingAndLayout) {
  const double ratio = std::sqrt(2.0);
  const auto trials = convergence_trials({ratio, 2}, 3);
  ASSERT_EQ(trials.size(), 4u);
  EXPECT_LT(trials[0].refinement, trials[1].refinement) << "the cheapest comes first";
  std::vector<Outcome> outcomes;
  for (const Trial& trial : trials) outcomes.push_back(made_up(trial, trial.repeat != 2));
  const auto intervals = find_intervals(made_up({}, true), trials, outcomes, ratio, 2);
  ASSERT_EQ(intervals.size(), 3u);
  const MetricInterval &cut = intervals[0], &time = intervals[1], &depth = intervals[2];
  EXPECT_EQ(depth.metric, "kerf.depth");
  EXPECT_EQ(depth.unit, "m");
  EXPECT_NEAR(depth.order, 1.0, 1e-9);
  // The depth for a spacing of zero is 4 mm, 1 mm below the value; with the factor 1.25.
  // The layouts differ by 0.3 mm: half of that to both sides, whichever the case has.
  EXPECT_NEAR(depth.low, 5e-3 - std::hypot(1.25e-3, 1.5e-4), 1e-12);
  EXPECT_NEAR(depth.high, 5e-3 + std::hypot(1.25e-3, 1.5e-4), 1e-12);
  EXPECT_NEAR(depth.spacing, 1.25e-3, 1e-12);
  EXPECT_NEAR(depth.layout, 1.5e-4, 1e-12);
  EXPECT_EQ(depth.runs, 5);
  EXPECT_EQ(cut.low, 0.0);
  EXPECT_EQ(cut.high, 1.0);
  EXPECT_THAT(interval_line(cut), HasSubstr("uncertain"));
  EXPECT_EQ(time.runs, 4) << "one run does not cut";
  EXPECT_EQ(time.low, time.high);
  EXPECT_THAT(interval_line(depth), HasSubstr("5 mm [3.74 mm, 6.26 mm]  spacing 99%, layout 1%"));
}

// Runs of a plate of 6 mm: the depth is of first order, 5.8 mm for a spacing of zero.
TEST(Convergence, NoDepthIsAboveTheThickness) {
  const double ratio = std::sqrt(2.0);
  const auto trials = convergence_trials({ratio, 2}, 1);
  const auto depths = [](const Trial& trial, double thickness) {
    Outcome outcome;
    const double depth = 5.8e-3 - 0.6e-3 / trial.refinement;
    outcome.metrics = {{"front_depth", depth},
                       {"kerf.depth", depth},
                       {"kerf.margin", -0.9 + 0.05 / trial.refinement},
                       {"kerf.thickness", thickness}};
    return outcome;
  };
  for (const double thickness : {5.9e-3, 5.3e-3, 4e-3}) {
    std::vector<Outcome> outcomes;
    for (const Trial& trial : trials) outcomes.push_back(depths(trial, thickness));
    const auto intervals = find_intervals(depths({}, thickness), trials, outcomes, ratio, 2);
    ASSERT_EQ(intervals.size(), 3u);
    for (const MetricInterval& interval : {intervals[0], intervals[1]}) {
      // At 4 mm the front has passed the workpiece.
      const double open = 5.2e-3 + 1.25 * 0.6e-3;
      EXPECT_NEAR(interval.high, thickness > 5e-3 ? thickness : open, 1e-12) << interval.metric;
      EXPECT_NEAR(interval.low, 5.2e-3 - 1.25 * 0.6e-3, 1e-12);
    }
    EXPECT_GE(intervals[2].low, -1.0);
  }
}

// The other layouts lie far below the first, which the sums of squares would leave out.
TEST(Convergence, ContainsWhatTheLayoutsMeasured) {
  const double ratio = std::sqrt(2.0);
  const auto trials = convergence_trials({ratio, 2}, 3);
  const auto depth = [](const Trial& trial) {
    Outcome outcome;
    static constexpr double by_layout[] = {0.0, -0.3e-3, -0.1e-3};
    outcome.metrics = {
        {"kerf.depth", 6.2e-3 - 0.3e-3 / std::pow(trial.refinement, 2) + by_layout[trial.repeat]}};
    return outcome;
  };
  std::vector<Outcome> outcomes;
  for (const Trial& trial : trials) outcomes.push_back(depth(trial));
  const auto intervals = find_intervals(depth({}), trials, outcomes, ratio, 2);
  EXPECT_NEAR(intervals[0].order, 2.0, 1e-6);
  for (std::size_t i = 1; i < trials.size(); ++i)  // all but the coarsest
    EXPECT_LE(intervals[0].low, outcomes[i].metrics.at("kerf.depth"));
}

TEST(Convergence, AMissingSpacingEndsTheSequence) {
  const double ratio = 1.4;
  const auto trials = convergence_trials({ratio, 2}, 1);
  std::vector<Outcome> outcomes;
  for (const Trial& trial : trials) outcomes.push_back(made_up(trial, true));
  outcomes[1].metrics.erase("kerf.depth");
  const auto intervals = find_intervals(made_up({}, true), trials, outcomes, ratio, 2);
  EXPECT_EQ(intervals[2].metric, "kerf.depth");
  EXPECT_EQ(intervals[2].rule, "unknown");
  EXPECT_TRUE(std::isnan(intervals[2].low) && std::isnan(intervals[2].high));
  EXPECT_THAT(interval_line(intervals[2]), HasSubstr("no interval"));
  EXPECT_EQ(intervals[2].runs, 2);
}

TEST(Convergence, TheCoarsestSpacingHasFiveParticlesAcrossTheJet) {
  Case description = parse_case(test::small_case, "small.toml");
  Jet& jet = description.jets.front();
  for (const double across : {8.0, 9.0, 10.0}) {
    jet.spacing = jet.width / across;
    const double ratio = convergence_spacings(description).ratio;
    EXPECT_NEAR(across / (ratio * ratio), 5.0, 0.05) << across;
  }
  jet.spacing = jet.width / 30.0;
  EXPECT_DOUBLE_EQ(convergence_spacings(description).ratio, std::sqrt(2.0));
  jet.spacing = jet.width / 2.0;
  EXPECT_DOUBLE_EQ(convergence_spacings(description).ratio, 1.26);
}

TEST(Convergence, OneLayoutLeavesItsPartOpen) {
  const double ratio = std::sqrt(2.0);
  for (const int layouts : {1, 3}) {
    const auto trials = convergence_trials({ratio, 2}, layouts);
    std::vector<Outcome> outcomes;
    for (const Trial& trial : trials) outcomes.push_back(made_up(trial, true));
    for (const MetricInterval& interval :
         find_intervals(made_up({}, true), trials, outcomes, ratio, 2)) {
      EXPECT_EQ(std::isnan(interval.layout), layouts == 1) << interval.metric;
      EXPECT_TRUE(layouts == 3 || interval_line(interval).find("layout") == std::string::npos);
    }
  }
}

}  // namespace
}  // namespace kerf
