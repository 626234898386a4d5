// SPDX-License-Identifier: Apache-2.0
#include "study/feed_by_exposure.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace kerf {

namespace {

// Returns the feeds of a run; none where its jet broke nothing, or no law of the depth shows. No
// feed is certain where the run denies it for the stated feed, and none exceeds that of the water.
std::optional<Bracket> feeds_of(const Outcome& outcome, const LimitPlan& plan) {
  const auto certain = outcome.metrics.find(std::string(certain_feed));
  const auto possible = outcome.metrics.find(std::string(possible_feed));
  if (outcome.failed || certain == outcome.metrics.end() || possible == outcome.metrics.end())
    return std::nullopt;
  Bracket feeds{certain->second, std::max(certain->second, possible->second)};
  const auto cuts = outcome.metrics.find("exposure.cuts");
  const bool is_denied = cuts != outcome.metrics.end() && cuts->second == 0.0;
  if (is_denied && feeds.low >= plan.stated) feeds.low = 0.0;
  feeds.low = std::min(feeds.low, plan.jet_speed);
  feeds.high = std::min(feeds.high, plan.jet_speed);
  return feeds;
}

std::string problem_of(const Outcome& outcome) {
  return outcome.failed
             ? fmt::format("run {} failed: {}", outcome.id, outcome.error)
             : fmt::format(
                   "run {} tells no feed: its jet did not go in, its front passed what is not "
                   "cut yet, which a later end may show, or the depth followed no law that could "
                   "be carried on",
                   outcome.id);
}

}  // namespace

ThresholdAnswer feed_by_exposure(const LimitPlan& plan, Laboratory& laboratory) {
  const ThresholdGoal& goal = *plan.study.threshold;
  const bool has_draft = goal.draft < 1.0;
  std::vector<Trial> trials;
  const auto ask = [&](int layout, double refinement) {
    Trial trial{{}, layout, refinement};
    trial.setting.numbers[goal.axis.name()] = plan.stated;
    trials.push_back(trial);
  };
  for (int layout = 0; layout < goal.repeats; ++layout) ask(layout, plan.study.refinement);
  if (has_draft) ask(0, goal.draft * plan.study.refinement);
  ThresholdAnswer answer;
  answer.refinement = plan.study.refinement;
  answer.runs = goal.repeats;
  answer.draft_runs = has_draft ? 1 : 0;
  for (const Outcome& outcome : laboratory.run(trials)) {
    const auto feeds = feeds_of(outcome, plan);
    if (!feeds) {
      answer.problem = problem_of(outcome);
      return answer;
    }
    answer.layouts.push_back(*feeds);
  }
  if (has_draft) {
    answer.draft = answer.layouts.back();
    answer.draft_refinement = trials.back().refinement;
    answer.layouts.pop_back();
  }
  answer.bracket = answer.layouts.front();
  for (const Bracket& feeds : answer.layouts)
    answer.bracket = {std::min(answer.bracket.low, feeds.low),
                      std::max(answer.bracket.high, feeds.high)};
  answer.stated = answer.bracket;
  if (answer.draft)
    answer.stated = {std::min(answer.stated.low, answer.draft->low),
                     std::max(answer.stated.high, answer.draft->high)};
  answer.extrapolated = answer.bracket.middle();
  answer.is_within_tolerance = true;
  return answer;
}

}  // namespace kerf
