// SPDX-License-Identifier: Apache-2.0
// Reductions of series with known results.
#include "verification/series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace kerf {
namespace {

TimeSeries sampled(const std::function<double(double)>& signal, double end, int samples) {
  TimeSeries series;
  for (int i = 0; i <= samples; ++i) {
    series.time.push_back(end * i / samples);
    series.value.push_back(signal(series.time.back()));
  }
  return series;
}

Parameters reduction(const std::map<std::string, std::string>& keys) {
  Parameters parameters("test");
  for (const auto& [key, value] : keys) parameters.set(key, value);
  return parameters;
}

TEST(Series, MeanWeightsUnevenSamplesByTime) {
  // The mean of a straight line is that of its ends for any sampling.
  const TimeSeries series{{0.0, 0.1, 0.2, 1.0}, {0.0, 0.1, 0.2, 1.0}};
  EXPECT_NEAR(reduce(series, reduction({{"reduce", "mean"}})), 0.5, 1e-14);
}

TEST(Series, WindowExcludesOtherSamples) {
  const auto series = sampled([](double t) { return t; }, 1.0, 100);
  const auto mean = reduction({{"reduce", "mean"}, {"from", "200 ms"}, {"to", "400 ms"}});
  EXPECT_NEAR(reduce(series, mean), 0.3, 1e-12);
  const auto last = reduction({{"reduce", "last"}, {"to", "0.5 s"}});
  EXPECT_NEAR(reduce(series, last), 0.5, 1e-12);
}

// A step load: 1 - exp(-a t) cos(w t) converges to 1. The period need not be known exactly: windows
// of 2.8 to 3.2 periods suffice, whereas their plain mean has an error of some percent.
TEST(Series, HannMeanOfADampedOscillation) {
  const auto swing = [](double t) {
    return 1.0 - std::exp(-0.25 * t) * std::cos(2.0 * std::numbers::pi * t);
  };
  for (const double periods : {2.8, 3.0, 3.2}) {
    const auto series = sampled(swing, periods, 1000);
    EXPECT_NEAR(reduce(series, reduction({{"reduce", "hann_mean"}})), 1.0, 0.005) << periods;
  }
  EXPECT_EQ(reduce({{1.0}, {7.0}}, reduction({{"reduce", "hann_mean"}})), 7.0);
}

TEST(Series, ValueBetweenSamples) {
  const TimeSeries series{{1.0, 2.0, 4.0}, {10.0, 30.0, -30.0}};
  EXPECT_EQ(value_at(series, 1.0), 10.0);
  EXPECT_NEAR(value_at(series, 1.25), 15.0, 1e-12);
  EXPECT_NEAR(value_at(series, 3.0), 0.0, 1e-12);
  EXPECT_EQ(value_at(series, 4.0), -30.0);
  EXPECT_TRUE(std::isnan(value_at(series, 0.9)));
  EXPECT_TRUE(std::isnan(value_at(series, 4.1)));
  EXPECT_TRUE(std::isnan(value_at({}, 1.0)));
}

TEST(Series, SlopeOfALine) {
  const auto series = sampled([](double t) { return 3.0 - 7.0 * t; }, 2.0, 50);
  EXPECT_NEAR(reduce(series, reduction({{"reduce", "slope"}})), -7.0, 1e-12);
}

TEST(Series, DecayRateOfAnExponential) {
  TimeSeries series;
  for (const double t : {0.0, 0.1, 0.35, 0.5}) {
    series.time.push_back(t);
    series.value.push_back(12.0 * std::exp(-3.0 * t));
  }
  EXPECT_NEAR(reduce(series, reduction({{"reduce", "decay_rate"}})), 3.0, 1e-12);
}

TEST(Series, PeriodOfADampedSine) {
  constexpr double period = 0.254;
  const auto series =
      sampled([](double t) { return std::exp(-t) * std::sin(2.0 * std::numbers::pi * t / period); },
              1.0, 400);
  EXPECT_NEAR(reduce(series, reduction({{"reduce", "period"}})) / period, 1.0, 1e-3);
}

TEST(Series, NoPeriodWithoutTwoCrossings) {
  const auto series = sampled([](double t) { return t - 0.5; }, 1.0, 3);
  EXPECT_TRUE(std::isnan(reduce(series, reduction({{"reduce", "period"}}))));
}

TEST(Series, PeakAndLargest) {
  const TimeSeries series{{0.0, 1.0, 2.0}, {1.0, -3.0, 2.0}};
  EXPECT_EQ(reduce(series, reduction({{"reduce", "peak"}})), 2.0);
  EXPECT_EQ(reduce(series, reduction({{"reduce", "largest"}})), -3.0);
}

TEST(Series, PeakOfMeanIsTheHeightOfAnOscillatingStep) {
  // A step to 100 at t = 0.3 with an oscillation of period 0.02, whose mean over 0.1 is 0.
  const auto series = sampled(
      [](double t) {
        return t < 0.3 ? 0.0 : 100.0 + 40.0 * std::sin(2.0 * std::numbers::pi * t / 0.02);
      },
      1.0, 2000);
  const double raw = reduce(series, reduction({{"reduce", "peak"}}));
  const double gauge = reduce(series, reduction({{"reduce", "peak_of_mean"}, {"over", "0.1 s"}}));
  EXPECT_GT(raw, 139.0);
  EXPECT_NEAR(gauge, 100.0, 1.0);
}

TEST(Series, PeakOfMeanNeedsALongEnoughSeries) {
  const auto series = sampled([](double) { return 1.0; }, 1.0, 10);
  const auto parameters = reduction({{"reduce", "peak_of_mean"}, {"over", "2 s"}});
  EXPECT_TRUE(std::isnan(reduce(series, parameters)));
}

TEST(Series, TimesOfALevel) {
  const TimeSeries series{{0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 5.0, 2.0, 6.0, 1.0}};
  EXPECT_EQ(reduce(series, reduction({{"reduce", "first_above"}, {"level", "3"}})), 1.0);
  EXPECT_EQ(reduce(series, reduction({{"reduce", "last_above"}, {"level", "3"}})), 3.0);
  EXPECT_TRUE(std::isnan(reduce(series, reduction({{"reduce", "first_above"}, {"level", "7"}}))));
}

// A straight line passes a level exactly, a parabola t^2 within its sagitta dt^2 / 4 between
// samples over its slope 2 t. Passing again later does not count.
TEST(Series, TimeBetweenTwoLevels) {
  const TimeSeries line{{0.0, 1.0, 2.0, 3.0, 4.0}, {-1.0, 1.0, 3.0, 0.0, 9.0}};
  const auto between = [&](const char* level, const char* upper) {
    return reduce(
        line, reduction({{"reduce", "time_between"}, {"level", level}, {"upper_level", upper}}));
  };
  EXPECT_DOUBLE_EQ(between("0", "2"), 1.0);
  EXPECT_DOUBLE_EQ(between("0", "6"), 3.0 + 2.0 / 3.0 - 0.5);
  EXPECT_TRUE(std::isnan(between("0", "10")));
  EXPECT_TRUE(std::isnan(between("-2", "2")));  // it starts above
  const auto parabola = sampled([](double t) { return t * t; }, 4.0, 40);
  const double seen = reduce(
      parabola, reduction({{"reduce", "time_between"}, {"level", "1.03"}, {"upper_level", "7.9"}}));
  EXPECT_NEAR(seen, std::sqrt(7.9) - std::sqrt(1.03), 0.1 * 0.1 / 8.0);
}

TEST(Series, RefusesUnknownReductions) {
  const TimeSeries series{{0.0}, {0.0}};
  EXPECT_THROW(reduce(series, reduction({{"reduce", "median"}})), std::logic_error);
  EXPECT_THROW(reduce(series, reduction({})), std::logic_error);
  EXPECT_THROW(reduce(series, reduction({{"reduce", "mean"}, {"from", "3 mm"}})), std::logic_error);
}

}  // namespace
}  // namespace kerf
