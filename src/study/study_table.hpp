// SPDX-License-Identifier: Apache-2.0
// The runs of a study as a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/study_database.hpp"
#include "study/study_plan.hpp"

namespace kerf {

// The keys that a study varies, each once: of [vary], of its search and of its calibration.
std::vector<Axis> all_axes(const StudyPlan& plan);
// The SI unit of a key or a metric; "" = none.
std::string unit_of(const StudyPlan& plan, const std::string& name);
// "name (unit)", as the heading of a column has it.
std::string with_unit(const std::string& name, std::string_view unit);
// The metrics that are shown: those of every table, of the study's goals, and those it names.
std::vector<std::string> shown_metrics(const StudyPlan& plan);

// study.csv: a row for each run, everything in SI units, which the header names.
std::string study_csv(const StudyPlan& plan, const std::vector<RunRow>& runs);
// The same for people: settings in the units of the study, a few metrics, aligned.
std::string study_text(const StudyPlan& plan, const std::vector<RunRow>& runs);

}  // namespace kerf
