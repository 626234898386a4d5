// SPDX-License-Identifier: Apache-2.0
// This header declares the server of kerf view --compare: it serves two runs side by side with all
// their frames to this machine alone. The page follows runs that proceed.
#pragma once

#include <filesystem>
#include <string>

#include "app/local_server.hpp"
#include "app/run_view.hpp"
#include "model/case.hpp"

namespace kerf {

class CompareServer : public LocalServer {
 public:
  // Throws UserError (exit_files) when one of the folders holds no run.
  CompareServer(const std::filesystem::path& first, const std::filesystem::path& second);

 private:
  // A run with the address of its files below the page.
  struct Part {
    Part(const std::filesystem::path& folder, const std::string& place);

    std::filesystem::path folder;
    Case description;
    RunView view;
  };

  std::string page();

  Part first_, second_;
};

}  // namespace kerf
