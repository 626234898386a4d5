// SPDX-License-Identifier: Apache-2.0
// This header declares what `kerf run --converge` does after the run: the same case at coarser
// spacings and in other layouts, and the intervals of the headline numbers.
#pragma once

#include <filesystem>
#include <string>

#include "app/executor_options.hpp"

namespace kerf {

struct Case;

struct ConvergeSettings {
  std::filesystem::path case_file;
  std::filesystem::path folder;  // of the run; the further runs are in its folder converge/
  int layouts = 3;
  std::string resume_command;
  bool quiet = false;  // prints nothing on standard output
  ExecutorOptions executor;
};

// Throws UserError when the case has no jet or its spacings cannot be made coarser.
void check_convergence(const Case& description, const ConvergeSettings& settings);

// Makes the further runs, adds the list `intervals` to result.json, writes the report again and
// prints the intervals unless quiet. Returns the signal that stopped it; 0 = none. A new call makes
// only the runs that are missing.
int converge(const Case& description, const ConvergeSettings& settings);

}  // namespace kerf
