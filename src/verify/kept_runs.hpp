// SPDX-License-Identifier: Apache-2.0
// Runs of `kerf verify` kept in a folder: a table that was stopped goes on, and a long one is made
// in parts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verify/recording.hpp"

namespace kerf {

class KeptRuns {
 public:
  KeptRuns() = default;
  // An empty path, as by default: keeps nothing and finds nothing.
  explicit KeptRuns(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // A run kept by this version of the program, of the same case text and resolution and looked at
  // by the same signals. What else has changed in the program's code it cannot know. Nothing where
  // the file is missing, damaged or of another run.
  std::optional<Recording> find(const std::string& case_name, const PlannedRun& run,
                                const std::vector<const Check*>& checks) const;

  // Puts the run into FOLDER/CASE/RUN.cbor, and its look beside it; a run that broke down is not
  // kept. Throws UserError (exit_files).
  void keep(const std::string& case_name, const PlannedRun& run,
            const std::vector<const Check*>& checks, const Recording& recording) const;

 private:
  std::filesystem::path folder_;
};

// "jet speed, 2 mm" -> "jet-speed-2-mm"
std::string file_name_of(const std::string& text);

}  // namespace kerf
