// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "case/units.hpp"
#include "core/version.hpp"
#include "study/metrics.hpp"
#include "study/study_answers.hpp"
#include "study/study_runs.hpp"
#include "study/study_table.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;

Json setting_json(const Setting& setting) {
  Json json = Json::object();
  for (const auto& [key, value] : setting.numbers) json[key] = value;
  for (const auto& [key, value] : setting.words) json[key] = value;
  return json;
}

Json axis_json(const Axis& axis) {
  const std::string unit = axis.path.unit();
  Json json{{"key", axis.name()}, {"unit", unit}, {"shown_unit", axis.shown_unit}};
  json["shown_factor"] = unit.empty() ? 1.0 : read_quantity("1 " + axis.shown_unit, unit).value;
  json["kind"] = !axis.words.empty() ? "words" : axis.is_range ? "range" : "list";
  json["scale"] = axis.is_logarithmic ? "log" : "linear";
  if (axis.words.empty())
    json["values"] = axis.values;
  else
    json["values"] = axis.words;
  return json;
}

Json run_json(const RunRow& row) {
  Json json{{"id", row.id},
            {"state", run_state_words[static_cast<std::size_t>(row.state)]},
            {"setting", setting_json(row.trial.setting)},
            {"repeat", row.trial.repeat},
            {"refinement", row.trial.refinement},
            {"spacing", row.spacing},
            {"attempts", row.attempts},
            {"started", row.started},
            {"ended", row.ended},
            {"error", row.error}};
  const bool is_done = row.state == RunState::done;
  json["report"] = is_done ? Json((run_folder(row.id) / "report.html").string()) : Json(nullptr);
  json["metrics"] = Json::object();
  for (const auto& [name, value] : row.metrics) json["metrics"][name] = value;
  return json;
}

// What was not found is null.
Json found(double value, const std::string& problem) {
  return problem.empty() ? Json(value) : Json(nullptr);
}

Json bracket_json(const Bracket& bracket) {
  return {{"low", bracket.low}, {"high", bracket.high}};
}

Json threshold_json(const ThresholdGoal& goal, const ThresholdAnswer& answer) {
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

Json number_or_null(std::optional<double> value) {
  return value ? Json(*value) : Json(nullptr);
}

Json optimum_json(const OptimumGoal& goal, const OptimumAnswer& answer) {
  return {{"find", goal.least ? "minimum" : "maximum"},
          {"metric", goal.metric},
          {"unit", metric_unit(goal.metric)},
          {"condition", goal.condition.text()},
          {"problem", answer.problem},
          {"setting", setting_json(answer.setting)},
          {"value", answer.value},
          {"low", answer.low},
          {"high", answer.high},
          {"draft_value", number_or_null(answer.draft_value)},
          {"extrapolated", number_or_null(answer.extrapolated)},
          {"runs", answer.runs},
          {"draft_runs", answer.draft_runs}};
}

Json calibration_json(const CalibrationGoal& goal, const CalibrationAnswer& answer) {
  Json json{{"key", goal.axis.name()},
            {"unit", goal.axis.path.unit()},
            {"at", setting_json(goal.at)},
            {"metric", goal.metric},
            {"metric_unit", metric_unit(goal.metric)},
            {"measured", goal.measured},
            {"uncertainty", goal.uncertainty},
            {"problem", answer.problem},
            {"value", found(answer.value, answer.problem)},
            {"low", found(answer.low, answer.problem)},
            {"high", found(answer.high, answer.problem)},
            {"sensitivity", answer.sensitivity},
            {"scatter", answer.scatter},
            {"runs", answer.runs}};
  json["predictions"] = Json::array();
  for (const PredictedCut& cut : answer.predictions)
    json["predictions"].push_back({{"setting", setting_json(cut.setting)},
                                   {"value", cut.value},
                                   {"low", cut.low},
                                   {"high", cut.high}});
  return json;
}

Json model_json(const ModelGoal& goal, const ReducedModel& model) {
  static constexpr const char* forms[] = {"power", "threshold_linear", "threshold_power"};
  Json json{{"form", forms[static_cast<std::size_t>(goal.form)]},
            {"formula", model.formula()},
            {"metric", goal.metric},
            {"unit", metric_unit(goal.metric)},
            {"drive", goal.drive},
            {"variables", goal.variables},
            {"problem", model.problem()},
            {"used_runs", model.used()}};
  if (!model.problem().empty()) return json;
  json["freedom"] = model.fit().freedom;
  json["residual"] = model.fit().residual;
  json["explained"] = model.fit().explained;
  json["parameters"] = Json::array();
  for (const ModelParameter& entry : model.parameters())
    json["parameters"].push_back(
        {{"name", entry.name}, {"value", entry.value}, {"low", entry.low}, {"high", entry.high}});
  json["valid"] = Json::object();
  for (const auto& [name, range] : model.ranges())
    json["valid"][name] = {{"low", range.low}, {"high", range.high}};
  return json;
}

Json boundary_json(const std::vector<Crossing>& boundary) {
  Json json = Json::array();
  for (const Crossing& crossing : boundary)
    json.push_back({{"key", crossing.key},
                    {"low", crossing.low},
                    {"high", crossing.high},
                    {"cuts_above", crossing.cuts_above},
                    {"at", setting_json(crossing.at)}});
  return json;
}

}  // namespace

std::string study_json(const StudyPlan& plan, const StudyAnswers& answers) {
  Json json{{"format", format},       {"title", plan.title},        {"name", plan.name},
            {"base", plan.base_name}, {"version", program_version}, {"refinement", plan.refinement},
            {"repeats", plan.repeats}};
  json["keys"] = Json::array();
  for (const Axis& axis : all_axes(plan)) json["keys"].push_back(axis_json(axis));
  json["metrics"] = Json::array();
  for (const std::string& name : shown_metrics(plan))
    json["metrics"].push_back({{"name", name}, {"unit", metric_unit(name)}});
  json["runs"] = Json::array();
  for (const RunRow& row : answers.runs) json["runs"].push_back(run_json(row));
  json["boundary"] = boundary_json(answers.boundary);
  if (answers.threshold) json["search"] = threshold_json(*plan.threshold, *answers.threshold);
  if (answers.optimum) json["search"] = optimum_json(*plan.optimum, *answers.optimum);
  if (answers.calibration)
    json["calibration"] = calibration_json(*plan.calibration, *answers.calibration);
  if (answers.model) json["model"] = model_json(*plan.model, *answers.model);
  return json.dump(2) + "\n";
}

}  // namespace kerf
