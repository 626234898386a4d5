// SPDX-License-Identifier: Apache-2.0
// This file implements kerf view, which shows a run in a browser with all its frames, also while it
// proceeds.
#include <fmt/format.h>

#include <csignal>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/view_server.hpp"

namespace kerf {

namespace {

ViewServer* running = nullptr;

void stop_serving(int) {
  if (running != nullptr) running->stop();
}

struct ViewOptions {
  std::string folder;
  int port = 0;
};

void view(const ViewOptions& options) {
  ViewServer server(options.folder);
  const int port = server.bind(options.port);
  fmt::print("http://127.0.0.1:{}{}  (Ctrl-C stops the server)\n", port, server.path());
  std::fflush(stdout);
  running = &server;
  std::signal(SIGINT, stop_serving);
  std::signal(SIGTERM, stop_serving);
  server.serve();
  running = nullptr;
}

}  // namespace

void add_view_command(CLI::App& program) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = program.add_subcommand(
      "view", "Show a run in a browser on this machine, also a run in progress");
  command->add_option("OUT", options->folder, "the folder of the run's results")->required();
  command->add_option("--port", options->port, "port on 127.0.0.1; 0 = any free port")
      ->check(CLI::Range(0, 65535));
  command->callback([options] { view(*options); });
}

}  // namespace kerf
