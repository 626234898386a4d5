// SPDX-License-Identifier: Apache-2.0
// This header declares programs that this one starts: a child that does not outlive it, and a
// command that is run to its end.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/executor.hpp"

namespace kerf {

class ChildProcess {
 public:
  // Starts the program in a process group of its own, so that Ctrl-C reaches this program alone.
  // Standard output and error go to a file. Throws UserError (exit_files) when it cannot be
  // started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& output);
  // Kills the program if it still runs.
  ~ChildProcess();
  ChildProcess(ChildProcess&&) noexcept;

  // Returns how it ended, nothing while it runs.
  std::optional<JobEnd> end();
  void send(int signal);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct CommandOutput {
  int exit_code = -1;  // -1 = the program does not exist
  std::string output;  // standard output
  std::string errors;  // standard error
};

// Runs a program of the PATH to its end, without a shell, and returns what it printed.
CommandOutput output_of(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace kerf
