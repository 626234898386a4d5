// SPDX-License-Identifier: Apache-2.0
// This file describes the feeds that runs with the nozzle at rest tell.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/answer_parts.hpp"
#include "study/feed_by_exposure.hpp"
#include "study/run_table.hpp"
#include "study/study_answers.hpp"

namespace kerf {

namespace {

std::string feed_text(const LimitPlan& plan, double feed) {
  return show_number(feed, plan.study.threshold->axis, 4);
}

// Returns the share of the thickness that is broken at the end of a run, 0 to 1.
double broken_share(const RunRow& row) {
  const double* margin = find_number(row, "kerf.margin");
  return margin && *margin < 0.0 ? 1.0 + *margin : 1.0;
}

// Returns the run that ended before its jet was through and went the least way; null = none did.
const RunRow* least_cut(const std::vector<RunRow>& runs) {
  const RunRow* least = nullptr;
  for (const RunRow& row : runs)
    if (row.state == RunState::done && find_number(row, "exposure.exponent"))
      if (!least || broken_share(row) < broken_share(*least)) least = &row;
  return least;
}

// Whether a metric is true of a run.
bool holds_of(const RunRow& row, const char* metric) {
  const double* value = find_number(row, metric);
  return row.state == RunState::done && value && *value != 0.0;
}

// Adds what makes the cuts of the runs those of a nozzle at rest only (docs/theory/exposure.md).
void add_doubts(const std::vector<RunRow>& runs, LimitWords& words) {
  const auto any = [&](const char* metric) {
    return std::any_of(runs.begin(), runs.end(),
                       [&](const RunRow& row) { return holds_of(row, metric); });
  };
  if (any("cracked_ahead"))
    words.notes.emplace_back(
        "A crack parted the workpiece ahead of the water. A moving nozzle leaves the crack of its "
        "first impact behind, so no feed is certain; the possible one is that of the water.");
  if (any("gave_way"))
    words.notes.emplace_back(
        "The workpiece gave way: the jet pressed it ahead or aside before it was cut. What gives "
        "way evades a moving nozzle, so no feed is certain; motion = \"travelling\" simulates it.");
}

// Says how far a run went that ended before its water was through.
std::string carried_text(const RunRow& row) {
  const double broken = 100.0 * broken_share(row);
  const std::string how =
      holds_of(row, "cut_through")
          ? fmt::format("The run ended before the water was through the {}",
                        holds_of(row, "cracked_ahead") ? "crack" : "cut")
          : fmt::format("The run ended with {:.3g}% of the thickness broken", broken);
  return how + ". The rest is carried on by the law of its depth, so no feed is certain.";
}

std::string feeds_text(const LimitPlan& plan, const Bracket& feeds, bool is_carried) {
  const std::string possible = feed_text(plan, feeds.high);
  if (feeds.low <= 0.0) return fmt::format("certain at no feed, possible up to {}", possible);
  return fmt::format("{} up to {}, possible up to {}", is_carried ? "expected" : "certain",
                     feed_text(plan, feeds.low), possible);
}

std::string stated_text(const LimitPlan& plan, const Bracket& feeds, bool is_carried) {
  const char* verdict = plan.stated > feeds.high  ? "does not cut"
                        : plan.stated > feeds.low ? "may cut: it is within the interval"
                        : is_carried              ? "is expected to cut"
                                                  : "cuts";
  return fmt::format("The stated {} {}.", feed_text(plan, plan.stated), verdict);
}

}  // namespace

void describe_feeds(const LimitPlan& plan, const LimitAnswer& answer, LimitWords& words) {
  const ThresholdAnswer& found = *answer.threshold;
  const RunRow* carried = least_cut(answer.runs);
  words.finding = feeds_text(plan, found.stated, carried != nullptr);
  words.notes.push_back(stated_text(plan, found.stated, carried != nullptr));
  add_doubts(answer.runs, words);
  if (carried)
    words.notes.push_back(carried_text(*carried));
  else if (found.stated.low > 0.0)
    words.notes.emplace_back(
        "The nozzle stands in the run, which answers for all feeds: the cut is certain while the "
        "jet covers a point, and possible while it stays within its own hole.");
  if (found.stated.high >= plan.jet_speed)
    words.notes.push_back(fmt::format("The possible feed is bounded by the speed of the jet, {}.",
                                      feed_text(plan, plan.jet_speed)));
  if (found.layouts.size() > 1 || found.draft)
    words.notes.push_back(fmt::format("The interval is that of {} layout{}{}.",
                                      found.layouts.size(),
                                      plural(static_cast<int>(found.layouts.size())),
                                      found.draft ? " and of a coarser spacing" : ""));
}

}  // namespace kerf
