// SPDX-License-Identifier: Apache-2.0
#include "study/nearest_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace kerf {

namespace {

using Points = std::vector<std::pair<double, double>>;

// Returns whether an interval, cut to the range of all runs, is within the range of some of them.
bool spans(const Points& some, const MetricByKey& all, const Bracket& interval) {
  const auto [least, greatest] = std::minmax_element(some.begin(), some.end());
  return least->first <= std::max(interval.low, all.begin()->first) &&
         greatest->first >= std::min(interval.high, all.rbegin()->first);
}

}  // namespace

Fit nearest_line(const MetricByKey& runs, double root, const Measurement& measured) {
  Points points(runs.begin(), runs.end());
  std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.first - root) < std::abs(b.first - root);
  });
  Fit fit;
  for (std::size_t count = std::min<std::size_t>(5, points.size()); count <= points.size();
       ++count) {
    const Points nearest(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count));
    fit = fit_line(nearest, root);
    if (fit.problem.empty() && has_slope(fit, 0.5) &&
        spans(nearest, runs, crossing_interval(fit, root, measured)))
      break;
  }
  return fit;
}

bool has_slope(const Fit& line, double share) {
  return share * std::abs(line.parameters[1]) > line.half_interval(1, 0.95);
}

// The bounds are the roots of a x^2 + 2 b x + c with x from `root`.
Bracket crossing_interval(const Fit& line, double root, const Measurement& measured) {
  const double factor = std::pow(student_factor(line.freedom, 0.95), 2);
  const double miss = line.parameters[0] - measured.value, slope = line.parameters[1];
  const double a = slope * slope - factor * line.covariance(1, 1);
  const double b = slope * miss - factor * line.covariance(0, 1);
  const double c = miss * miss - measured.uncertainty * measured.uncertainty -
                   factor * (line.residual * line.residual + line.covariance(0, 0));
  const double half = std::sqrt(std::max(0.0, b * b - a * c));
  return {root + (-b - half) / a, root + (-b + half) / a};
}

namespace {

// Over the width of an interval: how far a run just outside may be, and where one is made.
constexpr double reach = 0.15, step = 0.05;

// Returns the first run from `low` to `high`, or the last one, if there is any.
std::optional<double> run_within(const MetricByKey& runs, double low, double high, bool is_last) {
  const auto first = runs.lower_bound(low), end = runs.upper_bound(high);
  if (first == runs.end() || first->first > high) return std::nullopt;
  return is_last ? std::prev(end)->first : first->first;
}
std::optional<double> run_below(const MetricByKey& runs, const Bracket& interval) {
  const double width = interval.high - interval.low;
  return run_within(runs, interval.low - reach * width, interval.low, true);
}
std::optional<double> run_above(const MetricByKey& runs, const Bracket& interval) {
  const double width = interval.high - interval.low;
  return run_within(runs, interval.high, interval.high + reach * width, false);
}

}  // namespace

std::optional<double> key_beside(const MetricByKey& runs, const Bracket& interval) {
  const double width = interval.high - interval.low;
  const double first = runs.begin()->first, last = runs.rbegin()->first;
  if (interval.low > first && !run_below(runs, interval))
    return std::max(first, interval.low - step * width);
  if (interval.high < last && !run_above(runs, interval))
    return std::min(last, interval.high + step * width);
  return std::nullopt;
}

Bracket to_runs_beside(const MetricByKey& runs, const Bracket& interval) {
  return {run_below(runs, interval).value_or(interval.low),
          run_above(runs, interval).value_or(interval.high)};
}

}  // namespace kerf
