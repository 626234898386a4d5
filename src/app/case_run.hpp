// SPDX-License-Identifier: Apache-2.0
// This header declares a run of a case by a child process, which is watched until it ends.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/run_folder.hpp"

namespace kerf {

class CaseRun {
 public:
  enum class State { running, completed, stopped, failed };
  struct Order {
    std::filesystem::path program;  // the executable of Kerf
    std::filesystem::path case_file;
    std::filesystem::path folder;  // for the results
    Existing existing = Existing::refuse;
  };

  // Starts kerf run.
  explicit CaseRun(Order order);
  // Stops the run and waits until its checkpoint is written.
  ~CaseRun();

  const std::filesystem::path& folder() const { return order_.folder; }
  State state() const { return state_; }
  // Returns whether the folder holds this run, and not one that it is about to replace.
  bool has_begun() const;
  // Asks the run to write its checkpoint and to end.
  void stop() { stops_ = true; }
  // Returns the end of what the run has printed.
  std::string output() const;

 private:
  std::vector<std::string> arguments() const;
  void watch();

  Order order_;
  // The file that a run writes first: its number and the time in its entry of the folder.
  struct UsedCase {
    std::uint64_t number = 0;
    std::int64_t seconds = 0, nanoseconds = 0;
    bool operator==(const UsedCase&) const = default;
  };
  std::optional<UsedCase> used_case() const;
  std::optional<UsedCase> before_ = used_case();  // of an earlier run in the folder
  std::filesystem::path output_;
  std::atomic<State> state_ = State::running;
  std::atomic<bool> stops_ = false;
  mutable std::mutex mutex_;
  std::string problem_;  // why it was not started
  std::thread watcher_;
};

}  // namespace kerf
