// SPDX-License-Identifier: Apache-2.0
#include "study/study_answers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "study/answer_parts.hpp"
#include "study/run_table.hpp"
#include "study/setting_json.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

// What was not found is null.
Json found(double value, const std::string& problem) {
  return problem.empty() ? Json(value) : Json(nullptr);
}

Json threshold_members(const ThresholdGoal& goal, const ThresholdAnswer& answer) {
  Json json{{"find", goal.least ? "least" : "greatest"},
            {"key", goal.axis.name()},
            {"unit", goal.axis.path.unit()},
            {"condition", goal.condition.text()},
            {"problem", answer.problem},
            {"value", found(answer.value(), answer.problem)},
            {"low", found(answer.stated.low, answer.problem)},
            {"high", found(answer.stated.high, answer.problem)},
            {"bracket", bracket_json(answer.bracket)}};
  json["layouts"] = Json::array();
  for (const Bracket& layout : answer.layouts) json["layouts"].push_back(bracket_json(layout));
  json["draft"] = answer.draft ? bracket_json(*answer.draft) : Json(nullptr);
  json["draft_refinement"] = answer.draft_refinement;
  json["resolution_change"] = answer.resolution_change;
  json["extrapolated"] = answer.extrapolated;
  json["tolerance"] = goal.tolerance;
  json["within_tolerance"] = answer.is_within_tolerance;
  json["runs"] = answer.runs;
  json["draft_runs"] = answer.draft_runs;
  return json;
}

Answer describe(const ThresholdGoal& goal, const ThresholdAnswer& answer) {
  const auto shown = [&](double value) { return show_number(value, goal.axis); };
  Answer result{"search", threshold_members(goal, answer)};
  result.question = fmt::format("{} {} with {}", goal.least ? "Least" : "Greatest",
                                goal.axis.name(), goal.condition.text());
  if (!answer.problem.empty()) {
    result.finding = fmt::format("not found. {}.", answer.problem);
    return result;
  }
  result.finding = fmt::format("{}, between {} and {} ({} runs, {} of them drafts)",
                               shown(answer.value()), shown(answer.stated.low),
                               shown(answer.stated.high), answer.runs, answer.draft_runs);
  const auto layouts = static_cast<int>(answer.layouts.size());
  result.notes.push_back(fmt::format(
      "bracket over {} layout{}: {} to {}{}", layouts, plural(layouts), shown(answer.bracket.low),
      shown(answer.bracket.high), answer.is_within_tolerance ? "" : ", wider than the tolerance"));
  if (answer.alternates) result.notes.emplace_back(alternating_verdicts);
  if (!answer.draft) return result;
  result.notes.push_back(fmt::format(
      "at {:.3g} times the spacing: {} to {}; for spacing 0 that makes {}", 1.0 / goal.draft,
      shown(answer.draft->low), shown(answer.draft->high), shown(answer.extrapolated)));
  if (std::abs(answer.resolution_change) >
      2.0 * (answer.bracket.half_width() + answer.draft->half_width()))
    result.notes.emplace_back(
        "the drafts have a different threshold and are too coarse; choose draft nearer to 1, or a "
        "finer "
        "study");
  return result;
}

Json jump_json(const std::optional<MetricJump>& jump) {
  if (!jump) return nullptr;
  return {{"low", jump->low},
          {"high", jump->high},
          {"at_low", jump->at_low},
          {"at_high", jump->at_high}};
}

// Returns the value with its interval or, where the measurement leaves an end of the range open,
// what it does determine.
std::string calibrated(const CalibrationGoal& goal, const CalibrationAnswer& answer) {
  const std::string low = show_number(answer.low, goal.axis),
                    high = show_number(answer.high, goal.axis);
  const char* agrees = "of the range, agrees with the measurement, too";
  if (answer.is_open_below && answer.is_open_above)
    return fmt::format(
        "not determined: runs at both ends of the range, {} and {}, agree with "
        "the measurement",
        low, high);
  if (answer.is_open_above)
    return fmt::format("at least {}, determined only from below: {}, the end {}", low, high,
                       agrees);
  if (answer.is_open_below)
    return fmt::format("at most {}, determined only from above: {}, the start {}", high, low,
                       agrees);
  return fmt::format("{}, between {} and {}", show_number(answer.value, goal.axis), low, high);
}

Answer describe(const StudyPlan& plan, const CalibrationAnswer& answer) {
  const CalibrationGoal& goal = *plan.calibration;
  const std::string unit = unit_of(plan, goal.metric);
  Answer result{"calibration",
                {{"key", goal.axis.name()},
                 {"unit", goal.axis.path.unit()},
                 {"at", setting_json(goal.at)},
                 {"metric", goal.metric},
                 {"metric_unit", unit},
                 {"measured", goal.measured},
                 {"uncertainty", goal.uncertainty},
                 {"problem", answer.problem},
                 {"value", found(answer.value, answer.problem)},
                 {"low", found(answer.low, answer.problem)},
                 {"high", found(answer.high, answer.problem)},
                 {"open_below", answer.is_open_below},
                 {"open_above", answer.is_open_above},
                 {"sensitivity", answer.sensitivity},
                 {"scatter", answer.scatter},
                 {"jump", jump_json(answer.jump)},
                 {"runs", answer.runs},
                 {"predictions", Json::array()}},
                goal.axis.name()};
  const auto shown = [&](double value) { return show_number(value, goal.axis); };
  const auto metric = [&](double value) { return goal.metric_text(value); };
  for (const PredictedCut& cut : answer.predictions)
    result.members["predictions"].push_back({{"setting", setting_json(cut.setting)},
                                             {"value", cut.value},
                                             {"low", cut.low},
                                             {"high", cut.high}});
  if (!answer.problem.empty()) {
    result.finding = fmt::format("not calibrated. {}.", answer.problem);
    return result;
  }
  result.finding = fmt::format("{} ({} runs)", calibrated(goal, answer), answer.runs);
  if (answer.is_open_below || answer.is_open_above)
    result.notes.push_back(
        fmt::format("{} is as measured at {}; predictions cover only the range that was searched",
                    goal.metric, shown(answer.value)));
  if (answer.jump)
    result.notes.push_back(
        fmt::format("{} jumps from {} at {} to {} at {} across the measured {}: no value gives it",
                    goal.metric, metric(answer.jump->at_low), shown(answer.jump->low),
                    metric(answer.jump->at_high), shown(answer.jump->high), metric(goal.measured)));
  for (const PredictedCut& cut : answer.predictions)
    result.notes.push_back(fmt::format("at {}: {} {}, between {} and {}",
                                       show(cut.setting, all_axes(plan)), goal.metric,
                                       metric(cut.value), metric(cut.low), metric(cut.high)));
  return result;
}

Answer describe(const StudyPlan& plan, const ReducedModel& model) {
  const ModelGoal& goal = *plan.model;
  static constexpr const char* forms[] = {"power", "threshold_linear", "threshold_power"};
  Answer result{"model",
                {{"form", forms[static_cast<std::size_t>(goal.form)]},
                 {"formula", model.formula()},
                 {"metric", goal.metric},
                 {"unit", unit_of(plan, goal.metric)},
                 {"drive", goal.drive},
                 {"variables", goal.variables},
                 {"problem", model.problem()},
                 {"used_runs", model.used()}},
                "Model"};
  if (!model.problem().empty()) {
    result.finding = fmt::format("none. {}.", model.problem());
    return result;
  }
  result.question = fmt::format("Model of {} runs", model.used());
  result.finding = fmt::format("{}, R^2 = {:.4f}", model.formula(), model.fit().explained);
  Json& json = result.members;
  json["freedom"] = model.fit().freedom;
  json["residual"] = model.fit().residual;
  json["explained"] = model.fit().explained;
  json["parameters"] = Json::array();
  for (const ModelParameter& entry : model.parameters()) {
    json["parameters"].push_back(
        {{"name", entry.name}, {"value", entry.value}, {"low", entry.low}, {"high", entry.high}});
    result.notes.push_back(fmt::format("{} = {:.6g}, between {:.6g} and {:.6g} (SI)", entry.name,
                                       entry.value, entry.low, entry.high));
  }
  json["valid"] = Json::object();
  for (const auto& [name, range] : model.ranges())
    json["valid"][name] = {{"low", range.low}, {"high", range.high}};
  return result;
}

}  // namespace

std::vector<Answer> describe_answers(const StudyPlan& plan, const StudyAnswers& answers) {
  std::vector<Answer> result;
  const auto add_search = [&](Answer answer, const Condition& condition) {
    const std::string open = too_soon_sentence(condition, answers.runs);
    if (!open.empty()) answer.notes.push_back(open);
    result.push_back(std::move(answer));
  };
  if (answers.threshold)
    add_search(describe(*plan.threshold, *answers.threshold), plan.threshold->condition);
  if (answers.optimum)
    add_search(describe_optimum(plan, *answers.optimum), plan.optimum->condition);
  if (answers.calibration) result.push_back(describe(plan, *answers.calibration));
  if (answers.model) result.push_back(describe(plan, *answers.model));
  return result;
}

std::string answers_text(const std::vector<Answer>& answers) {
  std::string text;
  for (const Answer& answer : answers) {
    text += fmt::format("{}: {}\n", answer.question, answer.finding);
    for (const std::string& note : answer.notes) text += fmt::format("  {}\n", note);
  }
  return text;
}

const double* find_number(const RunRow& row, const std::string& name) {
  const auto& numbers = row.trial.setting.numbers;
  if (const auto key = numbers.find(name); key != numbers.end()) return &key->second;
  const auto metric = row.metrics.find(name);
  return metric == row.metrics.end() ? nullptr : &metric->second;
}

std::vector<ModelDatum> model_data(const ModelGoal& goal, double refinement,
                                   const std::vector<RunRow>& runs) {
  std::vector<std::string> names = goal.variables;
  if (!goal.drive.empty()) names.push_back(goal.drive);
  std::vector<ModelDatum> data;
  for (const RunRow& row : runs) {
    const auto value = row.metrics.find(goal.metric);
    if (row.state != RunState::done || row.trial.refinement != refinement ||
        value == row.metrics.end())
      continue;
    ModelDatum datum{{}, value->second};
    for (const std::string& name : names)
      if (const double* number = find_number(row, name)) datum.variables[name] = *number;
    if (datum.variables.size() == names.size()) data.push_back(std::move(datum));
  }
  return data;
}

}  // namespace kerf
