// SPDX-License-Identifier: Apache-2.0
// This file implements kerf view, which shows a run in a browser with all its frames, also while it
// proceeds, or edits a case there.
#include <fmt/format.h>

#include <csignal>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/compare_server.hpp"
#include "app/edit_server.hpp"
#include "app/executor_options.hpp"
#include "app/view_server.hpp"

namespace kerf {

namespace {

LocalServer* serving = nullptr;

void stop_serving(int) {
  if (serving != nullptr) serving->stop();
}

struct ViewOptions {
  std::string path, other;
  int port = 0;
  bool edits = false;
};

void serve(LocalServer& server, int wanted_port) {
  const int port = server.bind(wanted_port);
  fmt::print("http://127.0.0.1:{}{}  (Ctrl-C stops the server)\n", port, server.path());
  std::fflush(stdout);
  serving = &server;
  std::signal(SIGINT, stop_serving);
  std::signal(SIGTERM, stop_serving);
  server.serve();
  serving = nullptr;
}

void view(const ViewOptions& options) {
  if (options.edits) {
    EditServer server({options.path, "", this_program});
    return serve(server, options.port);
  }
  if (options.path.empty()) throw CLI::RequiredError("PATH");
  if (!options.other.empty()) {
    CompareServer server(options.path, options.other);
    return serve(server, options.port);
  }
  ViewServer server(options.path);
  serve(server, options.port);
}

}  // namespace

void add_view_command(CLI::App& program) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = program.add_subcommand(
      "view", "Show a run in a browser on this machine, also a run in progress, or edit a case");
  command->add_option("PATH", options->path,
                      "the folder of the run's results; with --edit the case file");
  CLI::Option* edits = command->add_flag(
      "--edit", options->edits,
      "edit a case in the browser, check it, run it and show the run; without a file, "
      "begin with a template");
  command
      ->add_option("--compare", options->other,
                   "the folder of another run: show both side by side, at one time")
      ->excludes(edits);
  command->add_option("--port", options->port, "port on 127.0.0.1; 0 = any free port")
      ->check(CLI::Range(0, 65535));
  command->callback([options] { view(*options); });
}

}  // namespace kerf
