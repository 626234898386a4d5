// SPDX-License-Identifier: Apache-2.0
// A program at work, which does not outlive this one.
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
  // Starts it in a process group of its own, so that Ctrl-C reaches this program alone. Standard
  // output and error go to a file. Throws UserError (exit_files) when it cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& output);
  // Kills it if it is still at work.
  ~ChildProcess();
  ChildProcess(ChildProcess&&) noexcept;

  // How it ended; nothing while it is at work.
  std::optional<JobEnd> end();
  void send(int signal);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kerf
