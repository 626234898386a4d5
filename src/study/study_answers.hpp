// SPDX-License-Identifier: Apache-2.0
// This header collects everything that a study found. describe_answers() describes each answer
// once; the terminal, study.json and study.html render that description.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "study/boundary.hpp"
#include "study/reduced_model.hpp"
#include "study/searches.hpp"
#include "study/study_database.hpp"
#include "study/study_plan.hpp"

namespace kerf {

struct StudyAnswers {
  std::vector<RunRow> runs;  // that this study requested
  std::vector<Crossing> boundary;
  std::optional<ThresholdAnswer> threshold;
  std::optional<OptimumAnswer> optimum;
  std::optional<CalibrationAnswer> calibration;
  std::optional<ReducedModel> model;
};

// One answer as every file of a study presents it.
struct Answer {
  std::string name;                // of its object in study.json
  nlohmann::ordered_json members;  // of that object, SI units
  std::string question = {};       // "Least machine.pressure with cut_through >= 0.5"
  std::string finding = {};        // the answer in the units of the study, or why there is none
  std::vector<std::string> notes = {};  // where the finding comes from
};

std::vector<Answer> describe_answers(const StudyPlan& plan, const StudyAnswers& answers);
// Returns "question: finding" of each answer, with its notes indented below.
std::string answers_text(const std::vector<Answer>& answers);

// Returns study.json, which docs/studies.md describes.
std::string study_json(const StudyPlan& plan, const StudyAnswers& answers);

// Returns a varied key of a run or a number of its result; null where the run has neither.
const double* find_number(const RunRow& row, const std::string& name);

// Returns the runs that a model is fitted to: those that are done, have the study's resolution and
// every number that the model needs.
std::vector<ModelDatum> model_data(const ModelGoal& goal, double refinement,
                                   const std::vector<RunRow>& runs);

}  // namespace kerf
