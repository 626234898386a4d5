// SPDX-License-Identifier: Apache-2.0
#include "study/limit_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/answer_parts.hpp"
#include "study/bisection.hpp"
#include "study/feed_by_exposure.hpp"
#include "study/metrics.hpp"
#include "study/run_table.hpp"
#include "study/study_answers.hpp"

namespace kerf {

namespace {

const ThresholdGoal& goal_of(const LimitPlan& plan) {
  return *plan.study.threshold;
}

std::string shown(const LimitPlan& plan, double value) {
  return show_number(value, goal_of(plan).axis, 4);
}

// Returns "12.4 mm/s, between 12 mm/s and 12.8 mm/s".
std::string interval_text(const LimitPlan& plan, double value, const Bracket& interval) {
  return fmt::format("{}, between {} and {}", shown(plan, value), shown(plan, interval.low),
                     shown(plan, interval.high));
}

// Returns the width of the column of values.
std::size_t value_width(const LimitPlan& plan) {
  constexpr std::size_t least = 14;
  return std::max(least, plan.quantity.size());
}

// Returns whether the condition is that the jet cuts, also all along its path.
bool is_cut(const LimitPlan& plan) {
  const std::string& metric = goal_of(plan).condition.metric;
  return metric == "cut_through" || metric == "kerf.through_share" || metric == certain_feed;
}

// Returns whether the condition is that the stated feed cuts for certain.
bool is_of_certainty(const LimitPlan& plan) {
  return goal_of(plan).condition.metric == certain_feed;
}

std::string verb(const LimitPlan& plan, bool holds) {
  if (is_of_certainty(plan))
    return holds ? "The jet cuts for certain" : "The jet is not certain to cut";
  if (is_cut(plan)) return holds ? "The jet cuts" : "The jet does not cut";
  return fmt::format("{} {}", goal_of(plan).condition.text(), holds ? "holds" : "does not hold");
}

// Returns "Greatest feed that still cuts (kerf.through_share >= 0.95)".
std::string question_of(const LimitPlan& plan) {
  const ThresholdGoal& goal = goal_of(plan);
  const std::string subject =
      fmt::format("{} {}", goal.least ? "Least" : "Greatest", plan.quantity);
  if (!is_cut(plan)) return fmt::format("{} with {}", subject, goal.condition.text());
  if (is_of_certainty(plan) && !plan.by_exposure)
    return fmt::format("{} that still cuts for certain ({} m/s)", subject, goal.condition.text());
  const std::string detail = plan.by_exposure || goal.condition.metric == "cut_through"
                                 ? std::string()
                                 : fmt::format(" ({})", goal.condition.text());
  return fmt::format("{} that still cuts{}", subject, detail);
}

// Describes a range in which all runs have the same verdict.
std::string without_limit(const LimitPlan& plan, bool holds) {
  const ThresholdGoal& goal = goal_of(plan);
  const bool is_upper = holds != goal.least;  // the end that the search has reached
  const double end = is_upper ? goal.axis.values.back() : goal.axis.values.front();
  const std::string far =
      plan.is_own_range ? fmt::format(", {} the stated {}",
                                      is_upper ? fmt::format("{:.3g} times", end / plan.stated)
                                               : fmt::format("1/{:.3g} of", plan.stated / end),
                                      shown(plan, plan.stated))
                        : std::string();
  const std::string from =
      plan.stated > goal.axis.values.front() && plan.stated < goal.axis.values.back()
          ? fmt::format("from {} ", shown(plan, plan.stated))
          : std::string();
  const std::string further =
      is_upper ? "Raise --to to search further" : "Lower --from to search further";
  if (is_of_certainty(plan) && !holds)
    return fmt::format("certain at no {} tried, {}{} {}{}. {}, or ask from another stated value",
                       plan.quantity, from, is_upper ? "up to" : "down to", shown(plan, end), far,
                       further);
  // Another condition may hold below a limit that cutting has above it.
  const std::string other = is_cut(plan)
                                ? ""
                                : fmt::format(", or ask for the {0} {1} by --find {0}",
                                              goal.least ? "greatest" : "least", plan.quantity);
  return fmt::format("none in the range. {} at {} {} {} {}{}. {}{}", verb(plan, holds),
                     holds ? "every" : "any", plan.quantity, is_upper ? "up to" : "down to",
                     shown(plan, end), far, further, other);
}

std::string stated_note(const LimitPlan& plan, const ThresholdAnswer& found) {
  constexpr double many = 10.0;
  const double ratio = plan.stated / found.value(), off = ratio - 1.0;
  const bool is_open = plan.stated > found.stated.low && plan.stated < found.stated.high;
  const std::string place =
      ratio < many ? fmt::format("{:.3g}% {} the limit", 100.0 * std::abs(off),
                                 off < 0.0 ? "below" : "above")
                   : fmt::format("{:.{}f} times the limit", ratio, ratio < 10.0 * many ? 1 : 0);
  return fmt::format("The stated {} is {}{}.", shown(plan, plan.stated), place,
                     is_open ? ", within its interval: whether it cuts is uncertain" : "");
}

std::vector<std::string> cause_notes(const LimitPlan& plan, const ThresholdAnswer& answer) {
  const ThresholdGoal& goal = goal_of(plan);
  const LimitCauses causes = causes_of(answer);
  std::vector<std::string> notes;
  if (answer.alternates) notes.emplace_back(alternating_verdicts);
  notes.push_back(fmt::format(
      "Bracket of the first layout: ± {}{}.", shown(plan, causes.bracket),
      answer.is_within_tolerance
          ? ""
          : fmt::format(", with all layouts wider than the tolerance of {:g}%: verdicts alternate, "
                        "layouts differ or the runs were used up",
                        100.0 * goal.tolerance)));
  if (causes.layout)
    notes.push_back(fmt::format("{} layouts: up to {} more.", answer.layouts.size(),
                                shown(plan, *causes.layout)));
  else
    notes.emplace_back("Layouts were not examined (--layouts, --converge).");
  if (causes.spacing)
    notes.push_back(fmt::format(
        "Spacing: {} with {:.3g} times the spacing, {} for a spacing of zero (first order).",
        shown(plan, answer.draft->middle()), answer.refinement / answer.draft_refinement,
        shown(plan, answer.extrapolated)));
  else
    notes.emplace_back(
        "The spacing was not examined: with a finer one the limit may lie outside (--converge).");
  notes.emplace_back("Material data have no intervals in a case, so their share is left out.");
  return notes;
}

}  // namespace

LimitCauses causes_of(const ThresholdAnswer& answer) {
  LimitCauses causes;
  if (answer.layouts.empty()) return causes;
  const Bracket& first = answer.layouts.front();
  causes.bracket = first.half_width();
  if (answer.layouts.size() > 1)
    causes.layout = std::max(first.low - answer.bracket.low, answer.bracket.high - first.high);
  if (answer.draft) causes.spacing = answer.extrapolated - first.middle();
  return causes;
}

std::optional<Bracket> bracket_of(const LimitPlan& plan, const std::vector<RunRow>& runs,
                                  const Trial& of) {
  std::map<double, bool> verdicts;
  for (const RunRow& row : runs)
    if (row.state == RunState::done && row.trial.repeat == of.repeat &&
        row.trial.refinement == of.refinement && !is_not_reached(row.metrics))
      verdicts[value_of_trial(plan, row)] = goal_of(plan).is_beyond(row.metrics);
  const auto [low, high] = decided_ends(verdicts);
  if (!low || !high) return std::nullopt;
  return Bracket{*low, *high};
}

int rounds_left(const Bracket& bracket, double tolerance, int side_by_side) {
  const double ratio = bracket.half_width() / (tolerance * std::abs(bracket.middle()));
  if (ratio <= 1.0) return 0;
  return static_cast<int>(std::ceil(std::log(ratio) / std::log(std::max(1, side_by_side) + 1.0)));
}

LimitWords describe_limit(const LimitPlan& plan, const LimitAnswer& answer) {
  LimitWords words;
  words.question = question_of(plan);
  if (plan.by_exposure && answer.threshold && answer.threshold->problem.empty()) {
    describe_feeds(plan, answer, words);
    words.notes.push_back(plan.held.front());
    return words;
  }
  if (!answer.threshold || !answer.threshold->problem.empty()) {
    const auto so_far = bracket_of(plan, answer.runs, {{}, 0, plan.study.refinement});
    const bool is_open =
        std::all_of(answer.runs.begin(), answer.runs.end(),
                    [&](const RunRow& row) { return rests_on_what_left(plan, row); });
    if (answer.threshold && is_open && !answer.runs.empty())
      words.finding = fmt::format("undecided at every {} tried", plan.quantity);
    else if (answer.threshold && answer.threshold->holds_everywhere)
      words.finding = without_limit(plan, *answer.threshold->holds_everywhere);
    else if (so_far)
      words.finding =
          fmt::format("not found yet; so far {}", interval_text(plan, so_far->middle(), *so_far));
    else
      words.finding = "not found yet";
    if (answer.threshold && !answer.threshold->holds_everywhere)
      words.notes.push_back(answer.threshold->problem + ".");
  } else {
    const ThresholdAnswer& found = *answer.threshold;
    words.finding = interval_text(plan, found.value(), found.stated);
    words.notes.push_back(stated_note(plan, found));
    for (std::string& note : cause_notes(plan, found)) words.notes.push_back(std::move(note));
  }
  for (const std::string& sentence : plan.held) words.notes.push_back(sentence);
  for (const auto& doubt_of :
       {undecided_sentence, left_whole_sentence, short_way_sentence, thin_jet_sentence}) {
    const std::string doubt = doubt_of(plan, answer.runs);
    if (!doubt.empty()) words.notes.push_back(doubt);
  }
  return words;
}

std::string trial_verdict(const LimitPlan& plan, const RunRow& row) {
  if (row.state != RunState::done)
    return std::string(run_state_words[static_cast<std::size_t>(row.state)]);
  if (is_not_reached(row.metrics)) return "not reached";
  if (is_undecided(plan, row)) return "undecided";
  const bool holds = goal_of(plan).condition.holds(row.metrics);
  if (is_cut(plan) && !holds && may_cut(row.metrics)) return "may cut";
  const double* through = find_number(row, "cut_through");
  const bool is_of_way = goal_of(plan).condition.metric == "kerf.through_share";
  if (is_of_way && !holds && through && *through != 0.0) return "cuts in part";
  if (is_cut(plan)) return holds ? "cuts" : "does not cut";
  return holds ? "holds" : "does not hold";
}

// Returns the margin of a run; none where it may cut, and tells no feed as certain.
std::string margin_text(const LimitPlan& plan, const RunRow& row) {
  const double* feed = find_number(row, std::string(certain_feed));
  const bool tells_none = trial_verdict(plan, row) == "may cut" && (!feed || *feed == 0.0);
  if (row.state != RunState::done || tells_none || is_not_reached(row.metrics)) return "-";
  const double percent = std::round(1e3 * goal_of(plan).condition.margin(row.metrics)) / 10.0;
  return percent == 0.0 ? "0.0%" : fmt::format("{:+.1f}%", percent);
}

std::string trial_heading(const LimitPlan& plan) {
  return fmt::format("  {:>3}  {:<{}}  {:<14}  {:>8}  {:>9}  {:>10}  {:>6}", "run", plan.quantity,
                     value_width(plan), "verdict", "margin", "depth/mm", "spacing/mm", "layout");
}

std::string trial_line(const LimitPlan& plan, std::size_t number, const RunRow& row) {
  const double depth = 1e3 * metric_of(row, "kerf.depth");
  return fmt::format("  {:>3}  {:<{}}  {:<14}  {:>8}  {:>9}  {:>10.4g}  {:>6}", number,
                     shown(plan, value_of_trial(plan, row)), value_width(plan),
                     trial_verdict(plan, row), margin_text(plan, row),
                     std::isfinite(depth) ? fmt::format("{:.4g}", depth) : "-", 1e3 * row.spacing,
                     row.trial.repeat);
}

}  // namespace kerf
