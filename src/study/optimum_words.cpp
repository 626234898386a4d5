// SPDX-License-Identifier: Apache-2.0
// This file describes the optimum of a study.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "study/answer_parts.hpp"
#include "study/run_table.hpp"
#include "study/setting_json.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

// Adds where the optimum lies, what was searched and the other optima that the runs show.
void add_surroundings(const StudyPlan& plan, const OptimumAnswer& answer, Answer& result) {
  const OptimumGoal& goal = *plan.optimum;
  Json& json = result.members;
  json["local"] = !answer.others.empty();
  json["ranges"] = json["neighbours"] = Json::object();
  json["others"] = Json::array();
  std::vector<std::string> lies, searched;
  for (std::size_t i = 0; i < goal.axes.size(); ++i) {
    const Axis& axis = goal.axes[i];
    const Bracket range{axis.values.front(), axis.values.back()};
    const auto text = [&](const char* word, const char* with, const Bracket& ends) {
      return fmt::format("{} {} {} {} {}", axis.name(), word, show_number(ends.low, axis), with,
                         show_number(ends.high, axis));
    };
    json["ranges"][axis.name()] = bracket_json(range);
    searched.push_back(text("from", "to", range));
    if (i >= answer.neighbours.size()) continue;
    json["neighbours"][axis.name()] = bracket_json(answer.neighbours[i]);
    lies.push_back(text("between", "and", answer.neighbours[i]));
  }
  const char* better = goal.least ? "lower" : "higher";
  if (!lies.empty())
    result.notes.push_back(
        fmt::format("it lies at {}, the neighbouring runs", fmt::join(lies, ", ")));
  result.notes.push_back(
      std::isnan(answer.value)
          ? fmt::format("searched was {}", fmt::join(searched, ", "))
          : fmt::format("searched was {}; a {} value between the runs is not excluded",
                        fmt::join(searched, ", "), better));
  for (const OtherOptimum& other : answer.others) {
    json["others"].push_back({{"setting", setting_json(other.setting)},
                              {"value", other.value},
                              {"refinement", other.refinement}});
    result.notes.push_back(fmt::format(
        "another local {} of the {}: {} at {}", goal.least ? "minimum" : "maximum",
        other.refinement < plan.refinement ? "drafts" : "runs",
        metric_text(other.value, unit_of(plan, goal.metric)), show(other.setting, plan.axes)));
  }
}

}  // namespace

Answer describe_optimum(const StudyPlan& plan, const OptimumAnswer& answer) {
  const OptimumGoal& goal = *plan.optimum;
  const std::string unit = unit_of(plan, goal.metric);
  Answer result{"search",
                {{"find", goal.least ? "minimum" : "maximum"},
                 {"metric", goal.metric},
                 {"unit", unit},
                 {"condition", goal.condition.text()},
                 {"problem", answer.problem},
                 {"setting", setting_json(answer.setting)},
                 {"value", answer.value},
                 {"low", answer.low},
                 {"high", answer.high},
                 {"draft_value", number_or_null(answer.draft_value)},
                 {"extrapolated", number_or_null(answer.extrapolated)},
                 {"runs", answer.runs},
                 {"draft_runs", answer.draft_runs}}};
  const auto shown = [&](double value) { return metric_text(value, unit); };
  const char* kind = answer.others.empty() ? (goal.least ? "Minimum" : "Maximum")
                                           : (goal.least ? "Local minimum" : "Local maximum");
  result.question = fmt::format("{} of {} with {}", kind, goal.metric, goal.condition.text());
  if (std::isnan(answer.value)) {
    result.finding = fmt::format("not found. {}.", answer.problem);
    add_surroundings(plan, answer, result);
    return result;
  }
  result.finding = fmt::format("{} at {} ({} runs, {} of them drafts)", shown(answer.value),
                               show(answer.setting, plan.axes), answer.runs, answer.draft_runs);
  if (answer.low < answer.high)
    result.notes.push_back(
        fmt::format("between {} and {}, by the change to the neighbouring runs, over {} layout{}{}",
                    shown(answer.low), shown(answer.high), goal.repeats, plural(goal.repeats),
                    answer.extrapolated ? " and the change to spacing 0" : ""));
  add_surroundings(plan, answer, result);
  if (answer.extrapolated)
    result.notes.push_back(
        fmt::format("there at {:.3g} times the spacing: {}; for spacing 0 that makes {}",
                    1.0 / goal.draft, shown(*answer.draft_value), shown(*answer.extrapolated)));
  else if (answer.problem.empty() && answer.draft_runs > 0)
    result.notes.push_back(fmt::format("at {:.3g} times the spacing {} does not hold there",
                                       1.0 / goal.draft, goal.condition.text()));
  if (!answer.problem.empty()) result.notes.push_back(fmt::format("but {}.", answer.problem));
  return result;
}

}  // namespace kerf
