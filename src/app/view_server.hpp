// SPDX-License-Identifier: Apache-2.0
// Serves the report of a result folder, with all its frames, to this machine alone; while the run
// goes on, the page follows it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace kerf {

class ViewServer {
 public:
  // Throws UserError (exit_files) when the folder holds no run.
  explicit ViewServer(const std::filesystem::path& folder);
  ~ViewServer();

  // Takes a port of the loopback interface, any free one for 0; the port. Throws UserError when it
  // is taken.
  int bind(int port);
  // Answers until stop(), which may be called by another thread or a signal, and also before.
  void serve();
  void stop();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kerf
