// SPDX-License-Identifier: Apache-2.0
#include "study/searches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "study/bisection.hpp"
#include "study/metrics.hpp"

namespace kerf {

namespace {

// Ends the search of a layout at a run that tells nothing.
struct NotReached {
  double value = 0.0;  // of the key, SI
  int runs = 0;        // of the round
};

Verdicts verdicts_of(const ThresholdGoal& goal, const Trial& at, Laboratory& laboratory) {
  return [&goal, at, &laboratory](const std::vector<double>& values) {
    std::vector<Trial> trials;
    for (const double value : values) {
      trials.push_back(at);
      trials.back().setting.numbers[goal.axis.name()] = value;
    }
    std::vector<bool> verdicts;
    for (const Outcome& outcome : laboratory.run(trials)) {
      if (outcome.failed)
        throw UserError(
            fmt::format("the search stopped: the run {} failed: {}. Correct the cause, then "
                        "start the search again with --retry.",
                        outcome.id, outcome.error),
            exit_run_failed);
      if (is_not_reached(outcome.metrics))
        throw NotReached{values[verdicts.size()], static_cast<int>(values.size())};
      verdicts.push_back(goal.is_beyond(outcome.metrics));
    }
    return verdicts;
  };
}

std::string why_nothing(const ThresholdGoal& goal, bool beyond_everywhere) {
  const bool holds = beyond_everywhere == goal.least;
  const char* end = beyond_everywhere ? "from" : "to";
  return fmt::format(
      "{} {} at {} = {} already, the {} of the range. {}", goal.condition.text(),
      holds ? "holds" : "does not hold", goal.axis.name(),
      show_number(beyond_everywhere ? goal.axis.values.front() : goal.axis.values.back(),
                  goal.axis),
      end, beyond_everywhere ? "Lower it" : "Raise it");
}

std::string why_not_reached(const ThresholdGoal& goal, double value) {
  return fmt::format(
      "No water has come to the workpiece within the run at {} = {}, which tells nothing of the "
      "cut. State a later `end` in [time], or none where the case has a [machine]; or narrow the "
      "range",
      goal.axis.name(), show_number(value, goal.axis));
}

// Searches one layout after another, each from the bracket of the previous one.
class ThresholdSearch {
 public:
  ThresholdSearch(const ThresholdGoal& goal, const Trial& at, Laboratory& laboratory)
      : goal_(goal),
        at_(at),
        laboratory_(laboratory),
        range_{goal.axis.values.front(), goal.axis.values.back()} {}

  ThresholdAnswer run() {
    answer_.refinement = at_.refinement;
    std::optional<Bracket> guess;
    if (goal_.draft < 1.0) guess = draft();
    if (!answer_.problem.empty()) return answer_;
    for (int repeat = 0; repeat < goal_.repeats; ++repeat) {
      Trial at = at_;
      at.repeat = repeat;
      guess = layout(at, guess);
      if (!answer_.problem.empty()) return answer_;
      answer_.layouts.push_back(*guess);
      if (runs_left() <= 0) break;
    }
    conclude();
    return answer_;
  }

 private:
  int runs_left() const { return goal_.most_runs - answer_.runs; }

  std::optional<Bracket> draft() {
    Trial at = at_;
    at.refinement = at_.refinement * goal_.draft;
    answer_.draft_refinement = at.refinement;
    answer_.draft = layout(at, std::nullopt);
    answer_.draft_runs = answer_.runs;
    // The result of the drafts may be wrong at their resolution; then the full range is searched.
    const bool found_none = !answer_.problem.empty() && runs_left() > 0;
    if (!found_none) return answer_.draft;
    answer_.problem.clear();
    answer_.draft.reset();
    return std::nullopt;
  }

  void search(Bisection& bisection, const std::optional<Bracket>& guess) const {
    if (guess)
      bisection.start_at(*guess);
    else if (goal_.start)
      bisection.leave(*goal_.start);
    bisection.narrow(goal_.tolerance, laboratory_.side_by_side());
  }

  Bracket layout(const Trial& at, const std::optional<Bracket>& guess) {
    Bisection bisection(verdicts_of(goal_, at, laboratory_), range_, runs_left(),
                        goal_.axis.is_logarithmic);
    try {
      search(bisection, guess);
    } catch (const NotReached& run) {
      answer_.runs += run.runs;
      answer_.problem = why_not_reached(goal_, run.value);
    }
    answer_.runs += bisection.count();
    answer_.alternates = answer_.alternates || bisection.alternates();
    answer_.holds_everywhere.reset();
    if (!answer_.problem.empty()) return bisection.bracket();
    if (const auto same = bisection.same_everywhere()) {
      answer_.problem = why_nothing(goal_, *same);
      answer_.holds_everywhere = *same == goal_.least;
    }
    if (answer_.problem.empty() && !bisection.is_confirmed())
      answer_.problem = fmt::format("{} runs were not enough. Raise \"runs\", or narrow the range",
                                    goal_.most_runs);
    return bisection.bracket();
  }

  void conclude() {
    answer_.bracket = answer_.layouts.front();
    for (const Bracket& layout : answer_.layouts) {
      answer_.bracket.low = std::min(answer_.bracket.low, layout.low);
      answer_.bracket.high = std::max(answer_.bracket.high, layout.high);
    }
    answer_.stated = answer_.bracket;
    answer_.extrapolated = answer_.layouts.front().middle();
    if (answer_.draft) extrapolate(*answer_.draft);
    answer_.is_within_tolerance =
        answer_.bracket.half_width() <= goal_.tolerance * std::abs(answer_.bracket.middle());
  }

  // Each threshold lies anywhere in its bracket, so that the value for spacing 0 has one too.
  void extrapolate(const Bracket& draft) {
    const Bracket& fine = answer_.layouts.front();
    const double ratio = 1.0 / goal_.draft;
    answer_.resolution_change = fine.middle() - draft.middle();
    answer_.extrapolated = at_zero_spacing(fine.middle(), draft.middle(), ratio);
    const double low = at_zero_spacing(fine.low, draft.high, ratio);
    answer_.stated.low = std::min(answer_.stated.low, range_.low >= 0.0 ? std::max(0.0, low) : low);
    answer_.stated.high =
        std::max(answer_.stated.high, at_zero_spacing(fine.high, draft.low, ratio));
  }

  const ThresholdGoal& goal_;
  const Trial& at_;
  Laboratory& laboratory_;
  Bracket range_;
  ThresholdAnswer answer_;
};

}  // namespace

bool Condition::is_of_feed(const std::map<std::string, double>& metrics) const {
  const bool asks_cut = metric == "cut_through" || metric == "kerf.through_share";
  return asks_cut && at_least && metrics.contains("exposure.cuts");
}

double Condition::uncertain_share(const std::map<std::string, double>& metrics) const {
  const auto dimension = metrics.find("dimension");
  const bool is_plane = dimension != metrics.end() && dimension->second == 2.0;
  const bool is_of_path = metric == "kerf.through_share" && at_least && !is_of_feed(metrics);
  return is_of_path && is_plane ? left_whole(metrics) : 0.0;
}

bool Condition::holds(const std::map<std::string, double>& metrics) const {
  if (is_of_feed(metrics)) return cuts(metrics).value_or(false);
  const auto found = metrics.find(metric);
  if (found == metrics.end()) return false;
  return at_least ? found->second >= bound : found->second <= bound;
}

bool Condition::may_hold(const std::map<std::string, double>& metrics) const {
  const auto found = metrics.find(metric);
  const double uncertain = uncertain_share(metrics);
  return uncertain > 0.0 && found != metrics.end() && found->second + uncertain >= bound;
}

double Condition::margin(const std::map<std::string, double>& metrics) const {
  const bool is_cut = metric == "cut_through" || is_of_feed(metrics);
  const auto found = metrics.find(is_cut ? "kerf.margin" : metric);
  if (found == metrics.end()) return holds(metrics) ? 0.0 : -1.0;
  if (is_cut) return holds(metrics) ? std::abs(found->second) : -std::abs(found->second);
  const double scale = std::max(std::abs(bound), std::numeric_limits<double>::min());
  return (at_least ? 1.0 : -1.0) * (found->second - bound) / scale;
}

std::string Condition::text() const {
  if (metric == "cut_through") return "cut-through";
  return fmt::format("{} {} {}", metric, at_least ? ">=" : "<=",
                     written.empty() ? fmt::format("{:.6g}", bound) : written);
}

ThresholdAnswer find_threshold(const ThresholdGoal& goal, const Trial& at, Laboratory& laboratory) {
  return ThresholdSearch(goal, at, laboratory).run();
}

}  // namespace kerf
