// SPDX-License-Identifier: Apache-2.0
#include "study/metric_jump.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "study/least_squares.hpp"

namespace kerf {

namespace {

constexpr std::size_t most_of_side = 4;  // runs of a side that tell its slope and scatter
constexpr double least_share = 0.25, least_scatters = 3.0, least_slopes = 2.0;

struct Side {
  double slope = 0.0;    // of the metric over the logarithm of the key
  double scatter = 0.0;  // standard deviation about the line; 0 from fewer than three runs
};

// Describes the runs of a side, the nearest first.
Side side_of(std::vector<std::pair<double, double>> runs) {
  runs.resize(std::min(runs.size(), most_of_side));
  Side side;
  if (runs.size() < 2) return side;
  if (runs.size() == 2) {
    side.slope = (runs[1].second - runs[0].second) / (runs[1].first - runs[0].first);
    return side;
  }
  const Fit line = fit_line(runs, runs.front().first);
  if (!line.problem.empty()) return side;
  return {line.parameters[1], line.residual};
}

// Returns whether all of the runs are on the same side of the target, which is `above` it.
bool all_beside(const std::vector<std::pair<double, double>>& runs, double target, bool above) {
  return std::all_of(runs.begin(), runs.end(), [&](const auto& run) {
    return above ? run.second >= target : run.second <= target;
  });
}

}  // namespace

std::optional<MetricJump> find_jump(const MetricByKey& runs, double low, double high,
                                    double target) {
  const double at_low = runs.at(low), at_high = runs.at(high);
  const double change = std::abs(at_high - at_low);
  std::vector<std::pair<double, double>> left(runs.begin(), std::next(runs.find(low)));
  std::reverse(left.begin(), left.end());
  const std::vector<std::pair<double, double>> right(runs.find(high), runs.end());
  const bool rises = at_high > at_low;
  if (!all_beside(left, target, !rises) || !all_beside(right, target, rises)) return std::nullopt;
  const auto [least, greatest] = std::minmax_element(
      runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const Side before = side_of(left), after = side_of(right);
  const double slope = std::max(std::abs(before.slope), std::abs(after.slope));
  const bool is_jump = change > 0.0 && change >= least_share * (greatest->second - least->second) &&
                       change >= least_scatters * std::max(before.scatter, after.scatter) &&
                       change >= least_slopes * slope * (high - low);
  if (!is_jump) return std::nullopt;
  return MetricJump{std::exp(low), std::exp(high), at_low, at_high};
}

namespace {

// The farthest agreeing run of a side, if it is beyond an interval, and the run that misses next to
// it, which is the same run at the end of the range.
struct Edge {
  double agrees = 0.0, misses = 0.0;
};
struct Edges {
  std::optional<Edge> low, high;
};

template <class Iterator>
std::optional<Edge> edge_of(Iterator run, Iterator end, double target, double uncertainty) {
  double misses = run == end ? 0.0 : run->first;
  for (; run != end; ++run) {
    if (std::abs(run->second - target) <= uncertainty) return Edge{run->first, misses};
    misses = run->first;
  }
  return std::nullopt;
}

Edges edges_beyond(const MetricByKey& runs, const Bracket& interval, double target,
                   double uncertainty) {
  Edges edges{edge_of(runs.begin(), runs.end(), target, uncertainty),
              edge_of(runs.rbegin(), runs.rend(), target, uncertainty)};
  if (edges.low && edges.low->agrees >= interval.low) edges.low.reset();
  if (edges.high && edges.high->agrees <= interval.high) edges.high.reset();
  return edges;
}

}  // namespace

Bracket agreeing_interval(const MetricByKey& runs, const Bracket& interval, double target,
                          double uncertainty) {
  const Edges edges = edges_beyond(runs, interval, target, uncertainty);
  Bracket result = interval;
  if (edges.low) result.low = edges.low->misses;
  if (edges.high) result.high = edges.high->misses;
  return result;
}

std::optional<double> undecided_value(const MetricByKey& runs, const Bracket& interval,
                                      double target, double uncertainty, double tolerance) {
  const Edges edges = edges_beyond(runs, interval, target, uncertainty);
  std::optional<double> middle;
  double widest = tolerance;
  for (const auto& edge : {edges.low, edges.high}) {
    if (!edge || std::abs(edge->agrees - edge->misses) <= widest) continue;
    widest = std::abs(edge->agrees - edge->misses);
    middle = 0.5 * (edge->agrees + edge->misses);
  }
  return middle;
}

Bracket supported_interval(const MetricByKey& runs, double root, const Bracket& interval,
                           double target, double uncertainty) {
  const auto is_off = [&](const auto& run) { return std::abs(run.second - target) > uncertainty; };
  Bracket result = interval;
  for (auto run = runs.begin(); run != runs.end() && run->first < root && is_off(*run); ++run)
    result.low = std::max(result.low, run->first);
  for (auto run = runs.rbegin(); run != runs.rend() && run->first > root && is_off(*run); ++run)
    result.high = std::min(result.high, run->first);
  return result;
}

}  // namespace kerf
