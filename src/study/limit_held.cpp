// SPDX-License-Identifier: Apache-2.0
// This file says what is the same in all runs of a limit, on which condition it rests, and where
// their ways are too short for it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/jet_direction.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "study/limit_answer.hpp"
#include "study/metrics.hpp"
#include "study/run_table.hpp"
#include "study/study_answers.hpp"

namespace kerf {

namespace {

// Says why the condition is more than cut-through; empty where it is that.
std::string condition_sentence(const LimitPlan& plan, const Case& description) {
  const Condition& condition = plan.study.threshold->condition;
  if (condition.metric == "kerf.through_share" && travels(description))
    return fmt::format(
        "The jet cuts where {}: the nozzle moves in the runs, and cut-through alone is reached "
        "with the first hole.",
        condition.text());
  if (condition.metric == certain_feed && !plan.by_exposure)
    return fmt::format(
        "The jet cuts for certain where {} m/s, the stated feed, of a nozzle that stands in the "
        "runs.",
        condition.text());
  return "";
}

}  // namespace

bool travels(const Case& description) {
  return !description.jets.empty() && traverse_speed(description.jets.front()) > 0.0;
}

std::vector<std::string> held_in(const LimitPlan& plan, const Case& description) {
  const double refinement = plan.study.refinement;
  const std::string coarser =
      refinement == 1.0 ? "" : fmt::format("{:.3g} times ", 1.0 / refinement);
  std::vector<std::string> held{
      fmt::format("Each run has {}the spacings of `kerf run` with its value: those that the case "
                  "does not state follow the jet.",
                  coarser)};
  if (plan.end.path > 0.0)
    held.push_back(fmt::format("The nozzle travels {:.4g} mm in each run.", 1e3 * plan.end.path));
  else if (plan.end.follows)
    held.emplace_back(
        stands_for_traverse(description)
            ? "Each run lasts as long as the exposure of the stated feed takes."
            : "Each run has the end that follows from its own setting, as the case states none.");
  else
    held.push_back(fmt::format("Each run lasts {:.4g} ms.", 1e3 * plan.end.end));
  const std::string doubt = condition_sentence(plan, description);
  if (!doubt.empty()) held.push_back(doubt);
  return held;
}

double value_of_trial(const LimitPlan& plan, const RunRow& row) {
  return row.trial.setting.numbers.at(plan.study.threshold->axis.name());
}

double metric_of(const RunRow& row, const char* name) {
  const double* found = find_number(row, name);
  return found ? *found : std::nan("");
}

bool rests_on_what_left(const LimitPlan& plan, const RunRow& row) {
  const Condition& condition = plan.study.threshold->condition;
  return row.state == RunState::done && !condition.holds(row.metrics) &&
         condition.may_hold(row.metrics);
}

bool is_undecided(const LimitPlan& plan, const RunRow& row) {
  return ended_too_soon(plan.study.threshold->condition, row) || rests_on_what_left(plan, row);
}

std::string undecided_sentence(const LimitPlan& plan, const std::vector<RunRow>& runs) {
  const auto count = std::count_if(runs.begin(), runs.end(), [&](const RunRow& row) {
    return is_undecided(plan, row) && !rests_on_what_left(plan, row);
  });
  if (count == 0) return "";
  return fmt::format(
      "{} run{} undecided: the jet was still cutting when {} ended, which counts as {}. A later "
      "`end` in [time] may {} the limit.",
      count, count == 1 ? " is" : "s are", count == 1 ? "it" : "they",
      plan.study.threshold->condition.metric == "cut_through" ? "no cut" : "not satisfying",
      plan.study.threshold->least ? "lower" : "raise");
}

std::string left_whole_sentence(const LimitPlan& plan, const std::vector<RunRow>& runs) {
  std::vector<std::string> values;
  for (const RunRow& row : runs)
    if (rests_on_what_left(plan, row))
      values.push_back(fmt::format(
          "{} ({:.2g}%)", show_number(value_of_trial(plan, row), plan.study.threshold->axis, 4),
          100.0 * left_whole(row.metrics)));
  if (values.empty()) return "";
  return fmt::format(
      "The runs at {} are undecided: this share of the workpiece left the domain unbroken, "
      "and "
      "without it the jet has not cut enough of its way, which counts as not satisfying. A wider "
      "[domain] that keeps it, or a support that holds it, may {} the limit.",
      fmt::join(values, ", "), plan.study.threshold->least ? "lower" : "raise");
}

std::string thin_jet_sentence(const LimitPlan& plan, const std::vector<RunRow>& runs) {
  constexpr double few = 5.0;  // particles across the jet
  std::vector<std::string> values;
  for (const RunRow& row : runs) {
    const double across = metric_of(row, "jet_resolution");
    if (row.state == RunState::done && across < few)
      values.push_back(fmt::format(
          "{} ({:.2g})", show_number(value_of_trial(plan, row), plan.study.threshold->axis, 4),
          across));
  }
  if (values.empty()) return "";
  return fmt::format(
      "Fewer than {:g} particles lie across the jet at {}: these verdicts may be those of the "
      "spacing. Choose a finer spacing, or state none so that it follows the jet.",
      few, fmt::join(values, ", "));
}

std::string short_way_sentence(const LimitPlan& plan, const std::vector<RunRow>& runs) {
  constexpr double few = 3.0;
  if (plan.study.threshold->condition.metric != "kerf.through_share") return "";
  std::vector<std::string> values;
  for (const RunRow& row : runs) {
    const double value = value_of_trial(plan, row);
    const double way = (plan.quantity == "feed" ? value : plan.feed) *
                       (metric_of(row, "end_time") - plan.end.start);
    if (row.state == RunState::done && way < few * metric_of(row, "kerf.lag"))
      values.push_back(show_number(value, plan.study.threshold->axis, 4));
  }
  if (values.empty()) return "";
  return fmt::format(
      "The kerf at {} lags by more than a third of the way of the nozzle: its verdict may be that "
      "of the beginning of the cut. A later `end` in [time], with a domain that holds the way, "
      "tells more.",
      fmt::join(values, ", "));
}

}  // namespace kerf
