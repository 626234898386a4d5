// SPDX-License-Identifier: Apache-2.0
// This header declares study.db, the SQLite database of all runs of a study. A change is on the
// disk when the call returns, so that no run is lost when the study is killed.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/case_maker.hpp"
#include "study/laboratory.hpp"
#include "study/metrics.hpp"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace kerf {

enum class RunState { waiting, running, done, failed };
inline constexpr std::array<std::string_view, 4> run_state_words{"waiting", "running", "done",
                                                                 "failed"};

// A row of the table of runs.
struct RunRow {
  std::string id;
  Trial trial;
  std::string case_text;
  double spacing = 0.0;  // m
  double memory = 0.0;   // bytes
  RunState state = RunState::waiting;
  int attempts = 0;                  // number of starts
  Metrics metrics;                   // of a completed run
  std::string error;                 // of a failed run
  std::string made, started, ended;  // UTC, ISO 8601; "" = has not happened
};

class StudyDatabase {
 public:
  // Opens the file, or creates it. Throws UserError (exit_files).
  explicit StudyDatabase(const std::filesystem::path& file);
  ~StudyDatabase();

  // Adds a run; an existing run is not changed.
  void add(const ResolvedCase& resolved, const Trial& trial);
  std::optional<RunRow> find(const std::string& id) const;
  std::vector<RunRow> runs() const;  // in the order in which they were added

  void mark_started(const std::string& id);
  void mark_done(const std::string& id, const Metrics& metrics);
  void mark_failed(const std::string& id, const std::string& error);
  // Puts the run back into the queue, whatever its state.
  void mark_waiting(const std::string& id);

  // Store texts by name, such as the study as it was read.
  void remember(const std::string& name, const std::string& text);
  std::string recall(const std::string& name) const;  // "" = there is none
  void forget(const std::string& name);

 private:
  void update(const std::string& sql, const std::vector<std::string>& values) const;

  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace kerf
