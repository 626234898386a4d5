// SPDX-License-Identifier: Apache-2.0
#include "study/calibration_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace kerf {

std::string CalibrationGoal::metric_text(double value) const {
  const std::string number = fmt::format("{:.4g}", value / shown_factor);
  return shown_unit.empty() ? number : number + " " + shown_unit;
}

Trial CalibrationRuns::trial(double value, const Setting& setting) const {
  Trial result{setting, 0, refinement_};
  result.setting.numbers[goal_.axis.name()] = value;
  return result;
}

bool CalibrationRuns::has_metric(const Outcome& outcome) const {
  return !outcome.failed && outcome.metrics.count(goal_.metric) > 0;
}

double CalibrationRuns::metric_of(const Outcome& outcome) const {
  if (has_metric(outcome)) return outcome.metrics.at(goal_.metric);
  if (!outcome.failed)
    throw UserError(
        fmt::format("the calibration stopped: the run {} has no {} by its end. Choose a later end "
                    "of the runs (time.end), or a narrower range.",
                    outcome.id, goal_.metric),
        exit_run_failed);
  throw UserError(fmt::format("the calibration stopped: the run {} gave no {}: {}. Put it right, "
                              "then start the study again with --retry.",
                              outcome.id, goal_.metric, outcome.error),
                  exit_run_failed);
}

std::vector<double> CalibrationRuns::measure(const std::vector<double>& values) {
  std::vector<Trial> trials;
  for (const double value : values) trials.push_back(trial(value, goal_.at));
  const auto outcomes = laboratory_.run(trials);
  std::vector<double> metrics;
  for (std::size_t i = 0; i < values.size(); ++i) {
    metrics.push_back(metric_of(outcomes[i]));
    known_[std::log(values[i])] = metrics.back();
  }
  return metrics;
}

void CalibrationRuns::try_values(const std::vector<double>& values) {
  std::vector<Trial> trials;
  for (const double value : values) trials.push_back(trial(value, goal_.at));
  const auto outcomes = laboratory_.run(trials);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (outcomes[i].failed || has_metric(outcomes[i]))
      known_[std::log(values[i])] = metric_of(outcomes[i]);
    else
      lacking_.push_back(std::log(values[i]));
}

MetricByKey::const_iterator CalibrationRuns::run_beside(double key) const {
  const double near = 1e-3 * goal_.tolerance;
  const auto found = known_.lower_bound(key - near);
  return found != known_.end() && found->first <= key + near ? found : known_.end();
}

double CalibrationRuns::made_run(double key) const {
  return known_.count(key) > 0 ? key : run_beside(key)->first;
}

double CalibrationRuns::metric_at(double key) {
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  if (const auto found = run_beside(key); found != known_.end()) return found->second;
  const double value = std::exp(key), metric = measure({value}).front();
  known_.erase(std::log(value));  // the same value but for rounding
  known_[key] = metric;
  return metric;
}

std::optional<std::pair<double, double>> CalibrationRuns::find_crossing() {
  const int count = std::max(4, laboratory_.side_by_side());
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(between(goal_.axis.values.front(), goal_.axis.values.back(),
                             static_cast<double>(i) / (count - 1), true));
  try_values(values);
  auto found = crossing();
  for (auto next = key_before_lacking(); !found && next && left() > 0;
       next = key_before_lacking()) {
    try_values({std::exp(*next)});
    found = crossing();
  }
  return found;
}

std::optional<std::pair<double, double>> CalibrationRuns::crossing() const {
  if (known_.size() < 2) return std::nullopt;
  for (auto left = known_.begin(), right = std::next(left); right != known_.end(); ++left, ++right)
    if ((left->second - goal_.measured) * (right->second - goal_.measured) <= 0.0)
      return std::pair{left->first, right->first};
  return std::nullopt;
}

// Returns the middle between the run that is nearest to the measured value, of those with a
// neighbour that lacks the metric, and that neighbour.
std::optional<double> CalibrationRuns::key_before_lacking() const {
  const MetricByKey runs = all();
  std::optional<double> middle;
  double least = std::numeric_limits<double>::infinity();
  for (auto left = runs.begin(); left != runs.end() && std::next(left) != runs.end(); ++left) {
    const auto right = std::next(left);
    const double miss =
        std::min(std::abs(left->second - goal_.measured), std::abs(right->second - goal_.measured));
    const bool is_edge = std::isinf(left->second) != std::isinf(right->second);
    if (!is_edge || miss >= least || right->first - left->first <= goal_.tolerance) continue;
    least = miss;
    middle = 0.5 * (left->first + right->first);
  }
  return middle;
}

std::string CalibrationRuns::no_crossing() const {
  std::string without;
  for (const auto& [key, metric] : all())
    if (std::isinf(metric))
      without += (without.empty() ? "" : ", ") + show_number(std::exp(key), goal_.axis, 4);
  const std::string remedy =
      without.empty() ? "Widen the range"
                      : fmt::format(
                            "The runs at {} have no {} by their end. Choose a later end of "
                            "the runs (time.end), or another range",
                            without, goal_.metric);
  if (known_.size() < 2)
    return fmt::format("fewer than two runs over the range of {} have {}. {}", goal_.axis.name(),
                       goal_.metric, remedy);
  const auto [least, most] =
      std::minmax_element(known_.begin(), known_.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; });
  return fmt::format("{} is between {} and {} {} {}, and {} was measured. {}", goal_.metric,
                     goal_.metric_text(least->second), goal_.metric_text(most->second),
                     without.empty() ? "over the range of" : "in the runs that have it, over",
                     goal_.axis.name(), goal_.metric_text(goal_.measured), remedy);
}

MetricByKey CalibrationRuns::all() const {
  MetricByKey runs = known_;
  for (const double key : lacking_) runs[key] = std::numeric_limits<double>::infinity();
  return runs;
}

}  // namespace kerf
