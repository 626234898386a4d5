// SPDX-License-Identifier: Apache-2.0
#include "study/searches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "study/bisection.hpp"
#include "study/metric_jump.hpp"
#include "study/nearest_line.hpp"

namespace kerf {

namespace {

constexpr double cover = 2.0;  // standard uncertainties of the measurement, for about 95%

class Calibrator {
 public:
  Calibrator(const CalibrationGoal& goal, double refinement, Laboratory& laboratory)
      : goal_(goal), refinement_(refinement), laboratory_(laboratory) {}

  CalibrationAnswer run() {
    if (goal_.metric == "cut_through")
      from_threshold();
    else
      from_metric();
    answer_.runs = goal_.most_runs - runs_left();
    if (answer_.problem.empty()) predict();
    return answer_;
  }

 private:
  Trial trial(double value, const Setting& setting) const {
    Trial result{setting, 0, refinement_};
    result.setting.numbers[goal_.axis.name()] = value;
    return result;
  }

  bool has_metric(const Outcome& outcome) const {
    return !outcome.failed && outcome.metrics.count(goal_.metric) > 0;
  }
  double metric_of(const Outcome& outcome) const {
    if (has_metric(outcome)) return outcome.metrics.at(goal_.metric);
    throw UserError(
        fmt::format("the calibration stopped: the run {} gave no {}{}{}. Put it right, then start "
                    "the study again with --retry.",
                    outcome.id, goal_.metric, outcome.failed ? ": " : "", outcome.error),
        exit_run_failed);
  }

  std::vector<double> measure(const std::vector<double>& values) {
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

  // Cutting begins at the given setting, so the key has the value at which it begins there.
  void from_threshold() {
    const double first = goal_.axis.values.front(), last = goal_.axis.values.back();
    const auto ends = measure({first, last});
    if ((ends[0] > 0.5) == (ends[1] > 0.5)) {
      answer_.problem =
          fmt::format("{} at both ends of the range of {}. Widen it",
                      ends[0] > 0.5 ? "the cut goes through" : "the cut does not go through",
                      goal_.axis.name());
      return;
    }
    const bool beyond = ends[1] > 0.5;
    Bisection bisection(
        [&](const std::vector<double>& values) {
          std::vector<bool> verdicts;
          for (const double metric : measure(values)) verdicts.push_back((metric > 0.5) == beyond);
          return verdicts;
        },
        {first, last}, goal_.most_runs, true);
    bisection.start_at({first, last});
    bisection.narrow(goal_.tolerance, laboratory_.side_by_side());
    answer_.low = bisection.bracket().low;
    answer_.high = bisection.bracket().high;
    answer_.value = std::sqrt(answer_.low * answer_.high);
  }

  void from_metric() {
    explore();
    const auto [low, high] = crossing();
    if (!answer_.problem.empty()) return;
    const auto miss = [&](double logarithm) { return metric_at(logarithm) - goal_.measured; };
    const auto is_narrow = [&](double a, double b) { return std::abs(b - a) <= goal_.tolerance; };
    // Half of the runs, since the method is slower than halving where the metric jumps.
    auto steps = static_cast<std::uintmax_t>(std::max(2, runs_left() / 2));
    auto root =
        boost::math::tools::toms748_solve(miss, low, high, miss(low), miss(high), is_narrow, steps);
    while (!is_narrow(root.first, root.second) && runs_left() > 0) {
      const double middle = 0.5 * (root.first + root.second);
      const bool is_low = (miss(middle) > 0.0) == (miss(root.first) > 0.0);
      (is_low ? root.first : root.second) = middle;
    }
    set_answer(made_run(root.first), made_run(root.second));
  }
  double made_run(double logarithm) const {
    return known_.count(logarithm) > 0 ? logarithm : run_beside(logarithm)->first;
  }
  int runs_left() const {
    return goal_.most_runs - static_cast<int>(known_.size() + lacking_.size());
  }

  // A run so near to another that it would tell nothing new is not made: the method steps by
  // rounding errors where a run has exactly the measured value.
  MetricByKey::const_iterator run_beside(double logarithm) const {
    const double near = 1e-3 * goal_.tolerance;
    const auto found = known_.lower_bound(logarithm - near);
    return found != known_.end() && found->first <= logarithm + near ? found : known_.end();
  }

  double metric_at(double logarithm) {
    if (const auto found = known_.find(logarithm); found != known_.end()) return found->second;
    if (const auto found = run_beside(logarithm); found != known_.end()) return found->second;
    const double value = std::exp(logarithm), metric = measure({value}).front();
    known_.erase(std::log(value));  // the same value but for rounding
    known_[logarithm] = metric;
    return metric;
  }

  // Samples the full range in one round. A run without the metric, such as a time of cut-through
  // where nothing is cut through, is left out.
  void explore() {
    const int count = std::max(4, laboratory_.side_by_side());
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
      values.push_back(between(goal_.axis.values.front(), goal_.axis.values.back(),
                               static_cast<double>(i) / (count - 1), true));
    try_values(values);
  }

  void try_values(const std::vector<double>& values) {
    std::vector<Trial> trials;
    for (const double value : values) trials.push_back(trial(value, goal_.at));
    const auto outcomes = laboratory_.run(trials);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (outcomes[i].failed || has_metric(outcomes[i]))
        known_[std::log(values[i])] = metric_of(outcomes[i]);
      else
        lacking_.push_back(std::log(values[i]));
  }

  // Returns two neighbours between which the metric crosses the measured value.
  std::pair<double, double> crossing() {
    if (known_.size() < 2) {
      answer_.problem = fmt::format("fewer than two runs over the range of {} have {}. Narrow it",
                                    goal_.axis.name(), goal_.metric);
      return {};
    }
    for (auto left = known_.begin(), right = std::next(left); right != known_.end();
         ++left, ++right)
      if ((left->second - goal_.measured) * (right->second - goal_.measured) <= 0.0)
        return {left->first, right->first};
    const auto [least, most] =
        std::minmax_element(known_.begin(), known_.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; });
    answer_.problem = fmt::format(
        "{} is between {:.4g} and {:.4g} (SI) over the range of {}, and {:.4g} was "
        "measured. Widen the range",
        goal_.metric, least->second, most->second, goal_.axis.name(), goal_.measured);
    return {};
  }

  void set_jump(const MetricJump& jump) {
    answer_.jump = jump;
    answer_.low = jump.low;
    answer_.high = jump.high;
    answer_.value = std::sqrt(jump.low * jump.high);
  }

  // Takes the root between the last two values and its interval from the line through the nearest
  // runs; across a jump these two values are the interval.
  void set_answer(double low, double high) {
    const double at_low = known_.at(low), at_high = known_.at(high);
    const double measurement = cover * goal_.uncertainty;
    const auto jump = find_jump(known_, low, high, goal_.measured);
    if (jump && std::abs(at_high - at_low) > 2.0 * measurement) {
      if (const auto nearest = agreeing_run(measurement))
        set_interval(*nearest, {low, high}, measurement);
      else
        set_jump(*jump);
      return;
    }
    const double share = at_high == at_low ? 0.5 : (goal_.measured - at_low) / (at_high - at_low);
    const double root = low + share * (high - low);
    const Fit line = nearest_line(known_, root);
    if (!line.problem.empty()) {
      answer_.problem = line.problem;
      return;
    }
    answer_.sensitivity = line.parameters[1];
    answer_.scatter = line.residual;
    if (!has_slope(line, 1.0)) {
      answer_.problem = fmt::format("{} hardly depends on {} here and cannot determine it",
                                    goal_.metric, goal_.axis.name());
      return;
    }
    const double scatter = student_factor(line.freedom, 0.95) * line.residual;
    const double uncertainty = std::hypot(measurement, scatter);
    const double half = std::max(uncertainty / std::abs(answer_.sensitivity), 0.5 * (high - low));
    set_interval(root, {root - half, root + half}, uncertainty);
  }

  // Returns the run nearest to the measured value, if it is within the uncertainty.
  std::optional<double> agreeing_run(double uncertainty) const {
    const auto miss = [&](const auto& run) { return std::abs(run.second - goal_.measured); };
    const auto nearest =
        std::min_element(known_.begin(), known_.end(),
                         [&](const auto& a, const auto& b) { return miss(a) < miss(b); });
    return miss(*nearest) <= uncertainty ? std::optional(nearest->first) : std::nullopt;
  }

  // Ends an interval about the root where runs miss the measured value. Runs that agree with it
  // beyond the interval lengthen it; the runs that are left find where the agreement ends.
  void set_interval(double root, const Bracket& interval, double uncertainty) {
    const Bracket start =
        supported_interval(all_runs(), root, interval, goal_.measured, uncertainty);
    while (runs_left() > 0) {
      const auto value =
          undecided_value(all_runs(), start, goal_.measured, uncertainty, goal_.tolerance);
      if (!value) break;
      try_values({std::exp(*value)});
    }
    const MetricByKey runs = all_runs();
    const Bracket within = agreeing_interval(runs, start, goal_.measured, uncertainty);
    const auto agrees = [&](const auto& run) {
      return std::abs(run.second - goal_.measured) <= uncertainty;
    };
    answer_.is_open_below = agrees(*runs.begin());
    answer_.is_open_above = agrees(*runs.rbegin());
    answer_.value = std::exp(root);
    answer_.low = std::max(goal_.axis.values.front(), std::exp(within.low));
    answer_.high = std::min(goal_.axis.values.back(), std::exp(within.high));
  }

  // Returns the runs with those that lack the metric, which miss every value of it.
  MetricByKey all_runs() const {
    MetricByKey runs = known_;
    for (const double logarithm : lacking_)
      runs[logarithm] = std::numeric_limits<double>::infinity();
    return runs;
  }

  // Runs each setting with the key at its value and at both ends of its interval, within the range.
  void predict() {
    const auto within = [&](double value) {
      return std::clamp(value, goal_.axis.values.front(), goal_.axis.values.back());
    };
    std::vector<Trial> trials;
    for (const Setting& setting : goal_.predict)
      for (const double value : {answer_.value, within(answer_.low), within(answer_.high)})
        trials.push_back(trial(value, setting));
    if (trials.empty()) return;
    const auto outcomes = laboratory_.run(trials);
    answer_.runs += static_cast<int>(trials.size());
    for (std::size_t i = 0; i < goal_.predict.size(); ++i) {
      const double value = metric_of(outcomes[3 * i]);
      const double low = metric_of(outcomes[3 * i + 1]), high = metric_of(outcomes[3 * i + 2]);
      answer_.predictions.push_back(
          {goal_.predict[i], value, std::min({value, low, high}), std::max({value, low, high})});
    }
  }

  const CalibrationGoal& goal_;
  double refinement_;
  Laboratory& laboratory_;
  MetricByKey known_;
  std::vector<double> lacking_;  // logarithms of the key at which runs have no such metric
  CalibrationAnswer answer_;
};

}  // namespace

CalibrationAnswer calibrate(const CalibrationGoal& goal, double refinement,
                            Laboratory& laboratory) {
  return Calibrator(goal, refinement, laboratory).run();
}

}  // namespace kerf
