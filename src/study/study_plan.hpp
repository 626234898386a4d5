// SPDX-License-Identifier: Apache-2.0
// This header declares the content of a study file as plain data. docs/studies.md describes it.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "core/embedded_text.hpp"
#include "study/axis.hpp"
#include "study/design.hpp"
#include "study/goals.hpp"

namespace kerf {

struct Case;

struct StudyPlan {
  std::string name;  // the stem of the file
  std::string file;  // its path, for messages
  std::string title;
  std::string text;         // of the file
  std::string base_name;    // the case that is varied, for messages
  toml::table base;         // with the keys of [set]
  int dimension = 2;        // of the base, which decides the units of amounts
  double refinement = 1.0;  // divides every spacing of the case
  int repeats = 1;          // runs of each setting, with different seeds
  std::vector<Axis> axes;   // of [vary]
  std::optional<Design> design;
  std::optional<ThresholdGoal> threshold;
  std::optional<OptimumGoal> optimum;
  std::optional<CalibrationGoal> calibration;
  std::optional<ModelGoal> model;
  std::vector<std::string> metrics;  // columns besides the standard ones
};

// Returns the plan of runs of one case as its file has it; no key is varied.
StudyPlan plan_of_case(const std::filesystem::path& case_file, const std::string& text,
                       const Case& description);

// Reads a study. Throws UserError, which names every problem. `base` names one of `templates` or a
// file beside the study.
StudyPlan read_study(const std::filesystem::path& file, std::span<const EmbeddedText> templates);
StudyPlan parse_study(const std::string& text, const std::filesystem::path& file,
                      std::span<const EmbeddedText> templates);

}  // namespace kerf
