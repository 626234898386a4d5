// SPDX-License-Identifier: Apache-2.0
// This header declares the server of kerf view: it serves the report of a result folder with all
// its frames to this machine alone. The page follows a run that proceeds.
#pragma once

#include <filesystem>

#include "app/local_server.hpp"
#include "app/run_view.hpp"

namespace kerf {

class ViewServer : public LocalServer {
 public:
  // Throws UserError (exit_files) when the folder holds no run.
  explicit ViewServer(const std::filesystem::path& folder);

 private:
  RunView view_;
};

}  // namespace kerf
