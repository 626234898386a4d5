// SPDX-License-Identifier: Apache-2.0
#include "core/version.hpp"
#include "input/units.hpp"
#include "study/run_table.hpp"
#include "study/setting_json.hpp"
#include "study/study_answers.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;

Json axis_json(const Axis& axis) {
  const std::string unit = axis.path.unit();
  Json json{{"key", axis.name()}, {"unit", unit}, {"shown_unit", axis.shown_unit}};
  json["shown_factor"] = axis.shown_factor();
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
  const std::string report = report_of(row);
  json["report"] = report.empty() ? Json(nullptr) : Json(report);
  json["metrics"] = Json::object();
  for (const auto& [name, value] : row.metrics) json["metrics"][name] = value;
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
    json["metrics"].push_back({{"name", name}, {"unit", unit_of(plan, name)}});
  json["runs"] = Json::array();
  for (const RunRow& row : answers.runs) json["runs"].push_back(run_json(row));
  json["boundary"] = boundary_json(answers.boundary);
  for (const Answer& answer : describe_answers(plan, answers)) json[answer.name] = answer.members;
  return json.dump(2) + "\n";
}

}  // namespace kerf
