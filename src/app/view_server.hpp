// SPDX-License-Identifier: Apache-2.0
// This header declares the server of kerf view: it serves the report of a result folder with all
// its frames to this machine alone. The page follows a run that proceeds.
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

  // Binds a port of the loopback interface, any free one for 0, and returns it. Throws UserError
  // when it is in use.
  int bind(int port);
  // Returns the path of the page, which begins with a random token, "/0f...3a/".
  const std::string& path() const;
  // Serves until stop() is called by another thread or a signal, also before serve().
  void serve();
  void stop();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kerf
