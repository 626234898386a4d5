// SPDX-License-Identifier: Apache-2.0
// Writes limit.json: the answer to a question for a limit, and its trials.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/version.hpp"
#include "study/limit_answer.hpp"
#include "study/metrics.hpp"
#include "study/run_table.hpp"
#include "study/study_answers.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

constexpr int limit_format = 1;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json trial_json(const LimitPlan& plan, const RunRow& row) {
  const Condition& condition = plan.study.threshold->condition;
  const bool is_told = row.state == RunState::done && !is_not_reached(row.metrics);
  Json json{{"value", value_of_trial(plan, row)},
            {"layout", row.trial.repeat},
            {"refinement", row.trial.refinement},
            {"spacing", row.spacing},
            {"state", run_state_words[static_cast<std::size_t>(row.state)]}};
  json["holds"] = is_told ? Json(condition.holds(row.metrics)) : Json(nullptr);
  json["margin"] = is_told ? number_or_null(condition.margin(row.metrics)) : Json(nullptr);
  json["not_reached"] = is_not_reached(row.metrics);
  json["undecided"] = is_undecided(plan, row);
  json["left_whole"] = left_whole(row.metrics);
  for (const auto& [key, name] : {std::pair{"cut_through", "cut_through"},
                                  {"cut_through_time", "cut_through_time"},
                                  {"depth", "kerf.depth"},
                                  {"width", "kerf.middle.width"},
                                  {"end_time", "end_time"},
                                  {"particles_across", "jet_resolution"}})
    json[key] = number_or_null(metric_of(row, name));
  const std::string report = report_of(row);
  json["report"] = report.empty() ? Json(nullptr) : Json(report);
  json["error"] = row.error;
  return json;
}

}  // namespace

nlohmann::ordered_json limit_json(const LimitPlan& plan, const LimitAnswer& answer) {
  const Axis& axis = plan.study.threshold->axis;
  Json json{{"format", limit_format},
            {"title", plan.study.title},
            {"case", plan.study.base_name},
            {"version", program_version},
            {"quantity", plan.quantity},
            {"stated", plan.stated},
            {"range", {{"low", axis.values.front()}, {"high", axis.values.back()}}},
            {"shown_unit", axis.shown_unit},
            {"shown_factor", axis.shown_factor()}};
  const LimitWords words = describe_limit(plan, answer);
  json["question"] = words.question;
  json["finding"] = words.finding;
  json["notes"] = words.notes;
  if (answer.threshold) {
    StudyAnswers answers;
    answers.threshold = answer.threshold;
    json.update(describe_answers(plan.study, answers).front().members);
    json["holds_everywhere"] =
        answer.threshold->holds_everywhere ? Json(*answer.threshold->holds_everywhere) : Json();
    const LimitCauses causes = causes_of(*answer.threshold);
    json["causes"] = {{"bracket", causes.bracket},
                      {"layout", causes.layout ? Json(*causes.layout) : Json()},
                      {"spacing", causes.spacing ? Json(*causes.spacing) : Json()},
                      {"material", nullptr}};
  }
  json["undecided"] = std::count_if(answer.runs.begin(), answer.runs.end(),
                                    [&](const RunRow& row) { return is_undecided(plan, row); });
  json["trials"] = Json::array();
  for (const RunRow& row : answer.runs) json["trials"].push_back(trial_json(plan, row));
  return json;
}

}  // namespace kerf
