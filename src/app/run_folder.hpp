// SPDX-License-Identifier: Apache-2.0
// This header declares the folder of a run's results.
#pragma once

#include <filesystem>
#include <string>

#include "output/files.hpp"

namespace kerf {

struct Case;

// The treatment of a folder that contains a run already.
enum class Existing { refuse, resume, replace };
// At most one of the two is asked for; resume wins.
constexpr Existing existing_of(bool resume, bool replace) {
  return resume ? Existing::resume : replace ? Existing::replace : Existing::refuse;
}

// Returns the folder of the results of a run whose user names none: out/<stem of the case file>.
std::filesystem::path default_folder(const std::filesystem::path& case_file);

// Returns the case of a result folder. Throws UserError (exit_files) if it contains no run.
Case case_of_run(const std::filesystem::path& folder);

// Writes the meshes of a case into a folder, with the names that case.used.toml has for them.
// Throws UserError (exit_files).
void keep_meshes(const Case& description, const std::filesystem::path& folder);

class RunFolder {
 public:
  // Creates the folder if it is missing and locks it for this process. Throws UserError
  // (exit_files) and changes nothing if it contains files that `existing` does not allow to change.
  RunFolder(std::filesystem::path path, const std::string& case_text, Existing existing);

  // Returns true when there is a checkpoint to continue from; otherwise the folder is empty.
  bool has_checkpoint() const { return has_checkpoint_; }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path used_case() const { return path_ / "case.used.toml"; }
  std::filesystem::path series() const { return path_ / "series.csv"; }
  std::filesystem::path result() const { return path_ / "result.json"; }
  std::filesystem::path report() const { return path_ / "report.html"; }
  std::filesystem::path checkpoint() const { return path_ / "checkpoint.h5"; }

 private:
  bool is_empty() const;
  void check(const std::string& case_text, Existing existing) const;
  void clear() const;

  std::filesystem::path path_;
  FolderLock lock_;
  bool has_checkpoint_ = false;
};

}  // namespace kerf
