// SPDX-License-Identifier: Apache-2.0
// A study as its file says it: plain data. The format is described in docs/studies.md.
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

struct StudyPlan {
  std::string name;  // the stem of the file
  std::string title;
  std::string text;         // of the file
  std::string base_name;    // the case that is varied, for messages
  toml::table base;         // with the keys of [set] put in
  double refinement = 1.0;  // every spacing of the case is divided by it
  int repeats = 1;          // runs of each setting, which differ in their seeds
  std::vector<Axis> axes;   // of [vary]
  std::optional<Design> design;
  std::optional<ThresholdGoal> threshold;
  std::optional<OptimumGoal> optimum;
  std::optional<CalibrationGoal> calibration;
  std::optional<ModelGoal> model;
  std::vector<std::string> metrics;  // of the tables, besides those that are always there
};

// Throws UserError, which names all that is wrong. `templates` are the cases that `base` may name
// besides files, which it looks for beside the study.
StudyPlan read_study(const std::filesystem::path& file, std::span<const EmbeddedText> templates);
StudyPlan parse_study(const std::string& text, const std::filesystem::path& file,
                      std::span<const EmbeddedText> templates);

}  // namespace kerf
