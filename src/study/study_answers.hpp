// SPDX-License-Identifier: Apache-2.0
// Everything that a study found, and the files that say so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/boundary.hpp"
#include "study/calibration.hpp"
#include "study/optimum_search.hpp"
#include "study/reduced_model.hpp"
#include "study/study_database.hpp"
#include "study/study_plan.hpp"
#include "study/threshold_search.hpp"

namespace kerf {

struct StudyAnswers {
  std::vector<RunRow> runs;  // that this study asked for
  std::vector<Crossing> boundary;
  std::optional<ThresholdAnswer> threshold;
  std::optional<OptimumAnswer> optimum;
  std::optional<CalibrationAnswer> calibration;
  std::optional<ReducedModel> model;
};

// A varied key of a run, or a number of its result; null where it has neither.
const double* find_number(const RunRow& row, const std::string& name);

// The runs that a model of the study is fitted to: done, at the study's resolution, with all that
// the model needs.
std::vector<ModelDatum> model_data(const ModelGoal& goal, double refinement,
                                   const std::vector<RunRow>& runs);

// study.json, described in docs/studies.md.
std::string study_json(const StudyPlan& plan, const StudyAnswers& answers);
// study.h5: the columns of study.csv as arrays.
std::string study_hdf5(const StudyPlan& plan, const std::vector<RunRow>& runs);
// A few lines for people.
std::string answers_text(const StudyPlan& plan, const StudyAnswers& answers);

}  // namespace kerf
