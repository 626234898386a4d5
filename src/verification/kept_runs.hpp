// SPDX-License-Identifier: Apache-2.0
// This class keeps runs of `kerf verify` in a folder, so that a stopped table can be continued and
// a long one made in parts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/recording.hpp"

namespace kerf {

class KeptRuns {
 public:
  KeptRuns() = default;
  // With an empty path, the default, it keeps nothing and finds nothing.
  explicit KeptRuns(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Returns a run kept by this version of the program, of the same case text and resolution and
  // with the same signals; other changes of the program's code are not noticed. Returns nothing
  // where the file is missing, damaged or of another run.
  std::optional<Recording> find(const std::string& case_name, const PlannedRun& run,
                                const std::vector<const Check*>& checks) const;

  // Writes the run to FOLDER/CASE/RUN.cbor, and its picture frame beside it; a run that failed is
  // not kept. Throws UserError (exit_files).
  void keep(const std::string& case_name, const PlannedRun& run,
            const std::vector<const Check*>& checks, const Recording& recording) const;

 private:
  std::filesystem::path folder_;
};

// Returns a file name: "jet-speed-2-mm" for "jet speed, 2 mm".
std::string file_name_of(const std::string& text);

}  // namespace kerf
