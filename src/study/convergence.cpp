// SPDX-License-Identifier: Apache-2.0
#include "study/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/line_slope.hpp"
#include "model/case.hpp"
#include "output/result_metrics.hpp"

namespace kerf {

namespace {

constexpr const char* headline_metrics[] = {
    "cut_through",       "cut_through_time",    "front_depth",       "kerf.depth",
    "kerf.middle.width", "kerf.removed_volume", "kerf.removal_rate", "kerf.margin"};

constexpr double usual_safety = 1.25, cautious_safety = 3.0;
// Observed orders outside of this range are accidental; up to the slack the greatest is used.
constexpr double least_order = 0.5, greatest_order = 2.0, order_slack = 0.1;

SpacingEffect range_of(std::span<const double> values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  SpacingEffect effect{values[0] - *least, *greatest - values[0]};
  effect.rule = SpacingRule::range;
  return effect;
}

// The rank of a layout at one spacing says nothing about its rank at another: half of the range to
// both sides.
SpacingEffect half_range_of(std::span<const double> values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double half = 0.5 * (*greatest - *least);
  return {half, half};
}

SpacingEffect grid_convergence(double change, double order, double ratio) {
  const double used = std::min(order, greatest_order);
  const double index = usual_safety * std::abs(change) / (std::pow(ratio, used) - 1.0);
  return {index, index, order, SpacingRule::grid_convergence};
}

// The effect where the observed order is too high: first order, which is lower.
SpacingEffect first_order_change(double change, double order, double ratio) {
  const double index = cautious_safety * std::abs(change) / (ratio - 1.0);
  return {index, index, order, SpacingRule::limited_order};
}

// The effect where the observed order is too low: that of the line f = f_0 + a h through the three
// values by least squares, with h = 1, r, r^2.
SpacingEffect first_order_fit(std::span<const double> values, double order, double ratio) {
  const std::array<double, 3> spacings{1.0, ratio, ratio * ratio};
  constexpr std::array<std::size_t, 3> runs{0, 1, 2};
  const double slope = line_slope(
      runs, [&](std::size_t i) { return spacings[i]; }, [&](std::size_t i) { return values[i]; });
  const double spacing = (spacings[0] + spacings[1] + spacings[2]) / 3.0;
  const double mean = (values[0] + values[1] + values[2]) / 3.0;
  const auto miss = [&](std::size_t i) {
    return values[i] - mean - slope * (spacings[i] - spacing);
  };
  const double deviation = std::hypot(miss(0), miss(1), miss(2));  // one degree of freedom
  const double width =
      cautious_safety * std::abs(slope * spacings[0]) + deviation + std::abs(miss(0));
  return {width, width, order, SpacingRule::limited_order};
}

const double* find_metric(const Outcome& outcome, const std::string& name) {
  const auto found = outcome.metrics.find(name);
  return found == outcome.metrics.end() ? nullptr : &found->second;
}

// The runs beside the run itself.
struct OtherRuns {
  const std::vector<Trial>& trials;
  const std::vector<Outcome>& outcomes;
  double ratio;
};

// The values of a metric: by spacing, the finest first, and by layout, that of the case first.
struct Samples {
  std::vector<double> by_spacing, by_layout;
  double greatest = 0.0;  // of all runs
  int runs = 0;
};

Samples samples_of(const std::string& name, const Outcome& run, const OtherRuns& others) {
  const auto& [trials, outcomes, ratio] = others;
  Samples samples;
  std::vector<std::pair<double, double>> levels{{1.0, *find_metric(run, name)}};
  double middle = 0.0;  // refinement at which the layouts were run
  for (const Trial& trial : trials) middle = std::max(middle, trial.refinement);
  samples.runs = 1;
  samples.greatest = levels.front().second;
  std::vector<std::pair<int, double>> layouts;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const double* value = outcomes[i].failed ? nullptr : find_metric(outcomes[i], name);
    if (!value) continue;
    ++samples.runs;
    samples.greatest = std::max(samples.greatest, *value);
    if (trials[i].repeat == 0) levels.emplace_back(trials[i].refinement, *value);
    if (trials[i].refinement == middle) layouts.emplace_back(trials[i].repeat, *value);
  }
  std::sort(levels.rbegin(), levels.rend());
  std::sort(layouts.begin(), layouts.end());
  for (const auto& [refinement, value] : levels) {
    const double expected = std::pow(ratio, -static_cast<double>(samples.by_spacing.size()));
    if (std::abs(refinement / expected - 1.0) > 1e-6) break;  // a run between has no such number
    samples.by_spacing.push_back(value);
  }
  for (const auto& [layout, value] : layouts) samples.by_layout.push_back(value);
  return samples;
}

std::string in_unit(double value, const std::string& unit) {
  if (unit == "m" || unit == "s") return fmt::format("{:.3g} m{}", 1e3 * value, unit);
  return unit == "1" ? fmt::format("{:.3g}", value) : fmt::format("{:.3g} {}", value, unit);
}

std::string verdict_line(const MetricInterval& interval) {
  if (interval.low == interval.high)
    return fmt::format("{:<20} {} in all {} runs", interval.metric,
                       interval.value > 0.5 ? "yes" : "no", interval.runs);
  return fmt::format("{:<20} {}, but the {} runs differ: the verdict is uncertain", interval.metric,
                     interval.value > 0.5 ? "yes" : "no", interval.runs);
}

// Widens an interval to the values that were measured in the layouts, then cuts it to what the
// metric can be. `thickness` is that of the workpiece; infinite = unknown.
void limit_to_possible(MetricInterval& interval, const Samples& samples, double thickness) {
  for (const double value : samples.by_layout) {
    interval.low = std::min(interval.low, value);
    interval.high = std::max(interval.high, value);
  }
  const std::string& name = interval.metric;
  // All headline numbers but the margin are amounts.
  const double least = name == "kerf.margin" ? -1.0 : 0.0;
  double greatest = std::numeric_limits<double>::infinity();
  if (name == "kerf.margin" || name == "cut_through") greatest = 1.0;
  // The front is below the workpiece where it has passed it.
  if ((name == "kerf.depth" || name == "front_depth") && samples.greatest <= thickness)
    greatest = thickness;
  if (interval.low < least) interval.low = least;
  if (interval.high > greatest) interval.high = greatest;
}

MetricInterval interval_of(const std::string& name, const Samples& samples, double ratio,
                           double thickness) {
  MetricInterval interval;
  interval.metric = name;
  interval.value = samples.by_spacing.front();
  interval.runs = samples.runs;
  const SpacingEffect spacing = name == "cut_through"
                                    ? range_of(samples.by_spacing)
                                    : effect_of_spacing(samples.by_spacing, ratio);
  const SpacingEffect layout =
      samples.by_layout.empty() ? SpacingEffect{} : half_range_of(samples.by_layout);
  interval.low = interval.value - std::hypot(spacing.below, layout.below);
  interval.high = interval.value + std::hypot(spacing.above, layout.above);
  limit_to_possible(interval, samples, thickness);
  interval.spacing = std::max(spacing.below, spacing.above);
  interval.layout = samples.by_layout.size() > 1 ? layout.above : std::nan("");
  interval.order = spacing.order;
  interval.rule = spacing_rules[static_cast<std::size_t>(spacing.rule)];
  return interval;
}

}  // namespace

SpacingEffect effect_of_spacing(std::span<const double> values, double ratio) {
  values = values.first(std::min<std::size_t>(values.size(), 3));
  if (values.size() < 2) {
    const double none = std::nan("");
    return {none, none, none, SpacingRule::unknown};
  }
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double scale = std::max(std::abs(*least), std::abs(*greatest));
  if (*greatest - *least <= 1e-12 * scale) return {};
  if (values.size() == 2) {
    const double index = cautious_safety * std::abs(values[1] - values[0]) / (ratio - 1.0);
    SpacingEffect effect{index, index};
    effect.rule = SpacingRule::two_spacings;
    return effect;
  }
  const double near = values[1] - values[0], far = values[2] - values[1];
  const bool converges = far != 0.0 && near / far > 0.0 && near / far < 1.0;
  if (!converges) {
    // Such a sequence does not tell on which side of its last value the answer lies.
    const double width = *greatest - *least;
    SpacingEffect effect{width, width};
    effect.rule = SpacingRule::range;
    return effect;
  }
  const double order = std::log(far / near) / std::log(ratio);
  if (order < least_order) return first_order_fit(values, order, ratio);
  if (order > greatest_order + order_slack) return first_order_change(near, order, ratio);
  return grid_convergence(near, order, ratio);
}

std::vector<Trial> convergence_trials(const CoarserSpacings& spacings, int layouts) {
  const double ratio = spacings.ratio;
  std::vector<Trial> trials;
  if (spacings.count > 1) trials.push_back({{}, 0, 1.0 / (ratio * ratio)});
  trials.push_back({{}, 0, 1.0 / ratio});
  for (int layout = 1; layout < layouts; ++layout) trials.push_back({{}, layout, 1.0 / ratio});
  return trials;
}

std::vector<MetricInterval> find_intervals(const Outcome& run, const std::vector<Trial>& trials,
                                           const std::vector<Outcome>& outcomes, double ratio,
                                           int dimension) {
  const double* laid_out = find_metric(run, "kerf.thickness");
  const double thickness =
      laid_out && *laid_out > 0.0 ? *laid_out : std::numeric_limits<double>::infinity();
  std::vector<MetricInterval> intervals;
  for (const char* name : headline_metrics) {
    if (!find_metric(run, name)) continue;
    intervals.push_back(
        interval_of(name, samples_of(name, run, {trials, outcomes, ratio}), ratio, thickness));
    const std::string unit = metric_unit(name, dimension);
    intervals.back().unit = unit.empty() ? "1" : unit;
  }
  return intervals;
}

std::string interval_line(const MetricInterval& interval) {
  if (interval.metric == "cut_through") return verdict_line(interval);
  const auto shown = [&](double value) { return in_unit(value, interval.unit); };
  if (std::isnan(interval.low))
    return fmt::format("{:<20} {}, no interval: no coarser run has this number", interval.metric,
                       shown(interval.value));
  const double spacing = interval.spacing * interval.spacing;
  const double all = spacing + interval.layout * interval.layout;
  const std::string parts = std::isnan(interval.layout) ? std::string("by the spacing alone")
                            : all > 0.0
                                ? fmt::format("spacing {:.0f}%, layout {:.0f}%",
                                              100.0 * spacing / all, 100.0 * (1.0 - spacing / all))
                                : std::string("no change");
  const std::string order =
      !std::isfinite(interval.order) ? std::string()
      : interval.rule == spacing_rules[static_cast<std::size_t>(SpacingRule::limited_order)]
          ? fmt::format(" 1, observed {:.2f} is outside {:g} to {:g}", interval.order, least_order,
                        greatest_order)
          : fmt::format(" of order {:.2f}", interval.order);
  return fmt::format("{:<20} {} [{}, {}]  {}; {}{}, {} runs", interval.metric,
                     shown(interval.value), shown(interval.low), shown(interval.high), parts,
                     interval.rule, order, interval.runs);
}

}  // namespace kerf
