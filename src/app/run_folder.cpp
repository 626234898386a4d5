// SPDX-License-Identifier: Apache-2.0
#include "app/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/run_log.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

fs::path made(const fs::path& path) {
  make_folder(path);
  return path;
}

// Returns whether the file was left by an interrupted write.
bool is_leftover(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with('.') && name.ends_with(".tmp");
}

bool is_result(const fs::path& path) {
  static const std::vector<std::string> names = {"result.json",
                                                 "series.csv",
                                                 "report.html",
                                                 "compare.html",
                                                 "checkpoint.h5",
                                                 log_name(LogFormat::text),
                                                 log_name(LogFormat::json)};
  const std::string name = path.filename().string();
  return std::find(names.begin(), names.end(), name) != names.end() || is_leftover(path) ||
         is_kept_mesh_name(name) || name.ends_with(".vtkhdf.series") ||
         name.ends_with(".paraview.py") || path.extension() == ".vtkhdf" ||
         (path.extension() == ".png" && path.parent_path().filename() == "pictures");
}

std::vector<fs::path> results_in(const fs::path& folder) {
  std::vector<fs::path> results;
  if (!fs::is_directory(folder)) return results;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_result(entry.path())) results.push_back(entry.path());
  return results;
}

}  // namespace

RunFolder::RunFolder(fs::path path, const std::string& case_text, Existing existing)
    : path_(std::move(path)), lock_(made(path_)) {
  try {
    if (is_empty()) return;
    check(case_text, existing);
    has_checkpoint_ = existing == Existing::resume && fs::exists(checkpoint());
    if (!has_checkpoint_) clear();
  } catch (const fs::filesystem_error& error) {
    throw UserError(
        fmt::format("cannot use the folder {}: {}. Choose another with --out, or change "
                    "its permissions.",
                    path_.string(), error.code().message()),
        exit_files);
  }
}

bool RunFolder::is_empty() const {
  return std::all_of(fs::directory_iterator(path_), fs::directory_iterator(),
                     [](const fs::directory_entry& entry) {
                       return is_leftover(entry.path()) ||
                              (entry.is_directory() && fs::is_empty(entry.path()));
                     });
}

void RunFolder::check(const std::string& case_text, Existing existing) const {
  if (!fs::exists(used_case()))
    throw UserError(
        fmt::format("{} is not empty and contains no run of Kerf. Choose another folder "
                    "with --out.",
                    path_.string()),
        exit_files);
  if (existing == Existing::refuse)
    throw UserError(
        fmt::format("{} contains a run already. Continue it with --resume, replace it by "
                    "--force, or choose another folder with --out.",
                    path_.string()),
        exit_files);
  // A checkpoint contains the case that it belongs to.
  if (existing == Existing::resume && !fs::exists(checkpoint()) &&
      read_file(used_case()) != case_text)
    throw UserError(
        fmt::format("{} contains a run of another case and no checkpoint. Replace it by "
                    "--force, or choose another folder with --out.",
                    path_.string()),
        exit_files);
}

// Removes only what a run of Kerf writes; the case is removed last, as it marks a folder of a run.
void RunFolder::clear() const {
  for (const char* inner : {"frames", "pictures", "."})
    for (const fs::path& file : results_in(path_ / inner)) fs::remove(file);
  fs::remove(used_case());
}

void keep_meshes(const Case& description, const std::filesystem::path& folder) {
  for (const MeshShape* mesh : meshes_of(description))
    write_file(folder / kept_mesh_name(*mesh), *mesh->content);
}

fs::path default_folder(const fs::path& case_file) {
  return "out" / case_file.stem();
}

Case case_of_run(const std::filesystem::path& folder) {
  const std::filesystem::path used = folder / "case.used.toml";
  if (!std::filesystem::exists(used))
    throw UserError(fmt::format("{} contains no run of Kerf (there is no case.used.toml). Name the "
                                "folder that was given to 'kerf run' by --out.",
                                folder.string()),
                    exit_files);
  return read_case(used);
}

}  // namespace kerf
