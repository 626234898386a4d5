// SPDX-License-Identifier: Apache-2.0
// This header describes the runs of a study as a table, once for study.csv, study.h5, the terminal
// and study.html.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/study_database.hpp"
#include "study/study_plan.hpp"

namespace kerf {

// Returns the keys that a study varies, each once: those of [vary], its search and its calibration.
std::vector<Axis> all_axes(const StudyPlan& plan);
// Returns the SI unit of a key or a metric; "" = none.
std::string unit_of(const StudyPlan& plan, const std::string& name);
// Returns "name (unit)", as the heading of a column has it.
std::string with_unit(const std::string& name, std::string_view unit);
// Returns the metrics of the tables: the standard ones, those of the study's goals and those that
// the study names, each once, without the keys that are varied.
std::vector<std::string> shown_metrics(const StudyPlan& plan);

// The outcome of a run. The words are those of the tables and of study.html.
enum class RunVerdict {
  cut_through,
  may_cut,
  not_cut_through,
  undecided,
  not_reached,
  done,
  failed,
  not_run_yet
};
inline constexpr std::array<std::string_view, 8> verdict_words{
    "cut through", "may cut", "not cut through", "undecided",
    "not reached", "done",    "failed",          "not run yet"};
// Returns whether the run cut through, under a nozzle that stands in place of one that moves
// whether its feed does; `undecided` where the run ended while the jet was still cutting, of a case
// whose time is no exposure that a feed sets; `not_reached` where no water has come to the
// workpiece, `done` where the result does not say so.
RunVerdict verdict_of(const RunRow& row);
// Returns whether a run does not satisfy a condition that more time may bring about, as the jet was
// still cutting when it ended.
bool ended_too_soon(const Condition& condition, const RunRow& row);
// Says how many runs did, which count as not satisfying; empty where none did.
std::string too_soon_sentence(const Condition& condition, const std::vector<RunRow>& runs);
// Returns the path of the run's report from the folder of the study; "" when the run is not done.
std::string report_of(const RunRow& row);
// Returns the value of the key in the units of the study; "as the case" where it is not set.
std::string shown_value(const Setting& setting, const Axis& axis);

// One column, in SI units: a number or a word for each run.
struct RunColumn {
  enum class Storage { numbers, whole_numbers, hexadecimal, choices, csv_only };

  std::string name;
  std::string unit = {};
  std::vector<double> numbers = {};  // NaN where a run has none
  std::vector<std::string> words = {};
  std::vector<std::string> choices = {};  // the words that there may be
  Storage storage = Storage::numbers;     // in study.h5
};
std::vector<RunColumn> run_columns(const StudyPlan& plan, const std::vector<RunRow>& runs);

// Returns study.csv: a row for each run; the header names the units.
std::string study_csv(const StudyPlan& plan, const std::vector<RunRow>& runs);
// Returns study.h5: the columns of study.csv as arrays.
std::string study_hdf5(const StudyPlan& plan, const std::vector<RunRow>& runs);
// Returns an aligned table for the terminal: the settings in the units of the study, a few metrics.
std::string study_text(const StudyPlan& plan, const std::vector<RunRow>& runs);

}  // namespace kerf
