// SPDX-License-Identifier: Apache-2.0
// This header declares the server of kerf view --edit: a page with a form for a case, which checks
// the case while it is written, saves it, runs it and shows the run.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/case_editor.hpp"
#include "app/case_run.hpp"
#include "app/local_server.hpp"
#include "app/run_view.hpp"

namespace kerf {

class EditServer : public LocalServer {
 public:
  struct Settings {
    std::filesystem::path file;     // the case; empty = named by the page
    std::filesystem::path folder;   // for a case without a name
    std::filesystem::path program;  // the executable of Kerf, for the run
  };
  // Throws UserError where the case cannot be read, or the program was built without the page.
  explicit EditServer(const Settings& settings);

 private:
  using Json = nlohmann::ordered_json;

  void set_routes();
  void set_view_routes();
  std::string page() const;
  Json start(const Json& request);
  Json start_pilot(const Json& request);
  void refuse_second_run() const;  // the mutex is locked
  // `changes`: what differs from the case, of a pilot run.
  void start_run(CaseRun::Order order, std::vector<std::string> changes = {});
  Json stop_run();
  Json run_state();
  // Returns the page of the run of this number. Throws RefusedRequest where there is none.
  std::shared_ptr<RunView> view(const std::string& number);

  std::filesystem::path program_;
  CaseEditor editor_;
  std::mutex mutex_;  // of what follows
  int runs_ = 0;      // number of the run
  std::unique_ptr<CaseRun> run_;
  std::vector<std::string> changes_;
  std::shared_ptr<RunView> view_;  // null until it has begun to write
};

}  // namespace kerf
