// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "study/bisection.hpp"
#include "study/calibration_runs.hpp"
#include "study/metric_jump.hpp"
#include "study/nearest_line.hpp"
#include "study/searches.hpp"

namespace kerf {

namespace {

constexpr double cover = 2.0;  // standard uncertainties of the measurement, for about 95%

class Calibrator {
 public:
  Calibrator(const CalibrationGoal& goal, double refinement, Laboratory& laboratory)
      : goal_(goal), laboratory_(laboratory), runs_(goal, refinement, laboratory) {}

  CalibrationAnswer run() {
    if (goal_.metric == "cut_through")
      from_threshold();
    else
      from_metric();
    answer_.runs = runs_.made();
    if (answer_.problem.empty()) predict();
    return answer_;
  }

 private:
  // Cutting begins at the given setting, so the key has the value at which it begins there.
  void from_threshold() {
    const double first = goal_.axis.values.front(), last = goal_.axis.values.back();
    const auto ends = runs_.measure({first, last});
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
          for (const double metric : runs_.measure(values))
            verdicts.push_back((metric > 0.5) == beyond);
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
    const auto crossing = runs_.find_crossing();
    if (!crossing) {
      answer_.problem = runs_.no_crossing();
      return;
    }
    const auto [low, high] = *crossing;
    const auto miss = [&](double key) { return runs_.metric_at(key) - goal_.measured; };
    const auto is_narrow = [&](double a, double b) { return std::abs(b - a) <= goal_.tolerance; };
    // Half of the runs, since the method is slower than halving where the metric jumps, and as an
    // interval needs runs at its ends.
    auto steps = static_cast<std::uintmax_t>(std::max(2, runs_.left() / 2));
    auto root =
        boost::math::tools::toms748_solve(miss, low, high, miss(low), miss(high), is_narrow, steps);
    root = {runs_.made_run(root.first), runs_.made_run(root.second)};
    while (!is_narrow(root.first, root.second) && runs_.left() > 0 && jump_of(root)) {
      const double middle = 0.5 * (root.first + root.second);
      const bool is_low = (miss(middle) > 0.0) == (miss(root.first) > 0.0);
      (is_low ? root.first : root.second) = runs_.made_run(middle);
    }
    set_answer(root.first, root.second);
  }

  std::optional<MetricJump> jump_of(const std::pair<double, double>& root) const {
    return find_jump(runs_.known(), root.first, root.second, goal_.measured);
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
    const double at_low = runs_.known().at(low), at_high = runs_.known().at(high);
    const double measurement = cover * goal_.uncertainty;
    const auto jump = jump_of({low, high});
    if (jump && std::abs(at_high - at_low) > 2.0 * measurement) {
      if (const auto nearest = agreeing_run(measurement))
        set_interval(*nearest, {low, high}, measurement);
      else
        set_jump(*jump);
      return;
    }
    const double share = at_high == at_low ? 0.5 : (goal_.measured - at_low) / (at_high - at_low);
    const double root = low + share * (high - low);
    Bracket interval = fitted_interval(root, 0.5 * (high - low));
    while (answer_.problem.empty() && runs_.left() > 0) {
      const auto next = key_beside(runs_.all(), interval);
      if (!next) break;
      runs_.try_values({std::exp(*next)});
      interval = fitted_interval(root, 0.5 * (high - low));
    }
    if (answer_.problem.empty()) set_interval(line_root_, interval, agreement_);
  }

  // Fits the line at the runs near the root, and returns the interval that follows.
  Bracket fitted_interval(double root, double least_half) {
    const double measurement = cover * goal_.uncertainty;
    const Fit line = nearest_line(runs_.known(), root, {goal_.measured, measurement});
    if (!line.problem.empty()) {
      answer_.problem = line.problem;
      return {};
    }
    answer_.sensitivity = line.parameters[1];
    answer_.scatter = line.residual;
    if (!has_slope(line, 1.0)) {
      answer_.problem = fmt::format("{} hardly depends on {} here and cannot determine it",
                                    goal_.metric, goal_.axis.name());
      return {};
    }
    agreement_ = std::hypot(measurement, student_factor(line.freedom, 0.95) * line.residual);
    line_root_ = root + (goal_.measured - line.parameters[0]) / line.parameters[1];
    const Bracket interval = crossing_interval(line, root, {goal_.measured, measurement});
    return {std::min(interval.low, line_root_ - least_half),
            std::max(interval.high, line_root_ + least_half)};
  }

  // Returns the run nearest to the measured value, if it is within the uncertainty.
  std::optional<double> agreeing_run(double uncertainty) const {
    const auto miss = [&](const auto& run) { return std::abs(run.second - goal_.measured); };
    const auto nearest =
        std::min_element(runs_.known().begin(), runs_.known().end(),
                         [&](const auto& a, const auto& b) { return miss(a) < miss(b); });
    return miss(*nearest) <= uncertainty ? std::optional(nearest->first) : std::nullopt;
  }

  // Ends an interval about the root where runs miss the measured value. Runs that agree with it
  // beyond the interval lengthen it; the runs that are left find where the agreement ends.
  void set_interval(double root, const Bracket& interval, double uncertainty) {
    const auto supported = [&] {
      return supported_interval(runs_.all(), root, interval, goal_.measured, uncertainty);
    };
    for (auto next = undecided_key(root, supported(), uncertainty); next && runs_.left() > 0;
         next = undecided_key(root, supported(), uncertainty))
      runs_.try_values({std::exp(*next)});
    const Bracket start = supported();
    const MetricByKey runs = runs_.all();
    const Bracket within =
        to_runs_beside(runs, agreeing_interval(runs, start, goal_.measured, uncertainty));
    const auto agrees = [&](const auto& run) {
      return std::abs(run.second - goal_.measured) <= uncertainty;
    };
    answer_.is_open_below = agrees(*runs.begin());
    answer_.is_open_above = agrees(*runs.rbegin());
    answer_.low = std::max(goal_.axis.values.front(), std::exp(within.low));
    answer_.high = std::min(goal_.axis.values.back(), std::exp(within.high));
    answer_.value = std::clamp(std::exp(root), answer_.low, answer_.high);
  }

  // Returns where a run would tell best how far the agreement reaches.
  std::optional<double> undecided_key(double root, const Bracket& interval,
                                      double uncertainty) const {
    const MetricByKey runs = runs_.all();
    const auto key = undecided_value(runs, interval, goal_.measured, uncertainty, goal_.tolerance);
    if (key) return key;
    return undecided_value(runs, {root, root}, goal_.measured, uncertainty, goal_.tolerance);
  }

  // Runs each setting with the key at its value and at both ends of its interval, within the range.
  void predict() {
    const auto within = [&](double value) {
      return std::clamp(value, goal_.axis.values.front(), goal_.axis.values.back());
    };
    std::vector<Trial> trials;
    for (const Setting& setting : goal_.predict)
      for (const double value : {answer_.value, within(answer_.low), within(answer_.high)})
        trials.push_back(runs_.trial(value, setting));
    if (trials.empty()) return;
    const auto outcomes = laboratory_.run(trials);
    answer_.runs += static_cast<int>(trials.size());
    for (std::size_t i = 0; i < goal_.predict.size(); ++i) {
      const double value = runs_.metric_of(outcomes[3 * i]);
      const double low = runs_.metric_of(outcomes[3 * i + 1]),
                   high = runs_.metric_of(outcomes[3 * i + 2]);
      answer_.predictions.push_back(
          {goal_.predict[i], value, std::min({value, low, high}), std::max({value, low, high})});
    }
  }

  const CalibrationGoal& goal_;
  Laboratory& laboratory_;
  CalibrationRuns runs_;
  double line_root_ = 0.0;  // where the line has the measured value
  double agreement_ = 0.0;  // by how much a run that agrees may miss the measured value
  CalibrationAnswer answer_;
};

}  // namespace

CalibrationAnswer calibrate(const CalibrationGoal& goal, double refinement,
                            Laboratory& laboratory) {
  return Calibrator(goal, refinement, laboratory).run();
}

}  // namespace kerf
