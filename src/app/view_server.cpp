// SPDX-License-Identifier: Apache-2.0
#include "app/view_server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <mutex>
#include <random>

#include "app/run_folder.hpp"
#include "core/error.hpp"
#include "model/case.hpp"
#include "report/html.hpp"
#include "report/report.hpp"
#include "report/report_figures.hpp"
#include "report/viewer_data.hpp"

namespace kerf {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// Returns the time of cut-through from the series, s; -1 if there is none.
double cut_time_of(const SeriesTable& series) {
  const auto time = series.numbers("time"), cut = series.numbers("cut_through");
  for (std::size_t i = 0; i < cut.size(); ++i)
    if (cut[i] != 0.0) return time[i];
  return -1.0;
}

// Tests between requests whether the server must stop, because a call of stop() before the server
// listens would be lost.
class WatchfulPool : public httplib::ThreadPool {
 public:
  WatchfulPool(httplib::Server& server, const std::atomic<bool>& ends)
      : ThreadPool(threads), server_(server), ends_(ends) {}
  void on_idle() override {
    if (ends_) server_.stop();
  }

 private:
  static constexpr std::size_t threads = 64;  // a client that sends slowly keeps one of them
  httplib::Server& server_;
  const std::atomic<bool>& ends_;
};

// Returns 128 random bits, in hexadecimal.
std::string random_token() {
  std::random_device random;
  std::string token;
  for (int word = 0; word < 4; ++word) token += fmt::format("{:08x}", random());
  return token;
}

constexpr int idle_microseconds = 50'000;

// Whether a header "Host" names this machine by itself. A page of another site can lead a name of
// its own to 127.0.0.1 and would read the run by it (DNS rebinding).
bool is_this_machine(std::string_view host) {
  host = host.substr(0, host.find(':'));
  return host == "127.0.0.1" || host == "localhost";
}
bool may_ask(const httplib::Request& request) {
  const std::string origin = request.get_header_value("Origin");
  constexpr std::string_view scheme = "http://";
  if (!origin.empty() && (origin.rfind(scheme, 0) != 0 ||
                          !is_this_machine(std::string_view(origin).substr(scheme.size()))))
    return false;
  return is_this_machine(request.get_header_value("Host"));
}

}  // namespace

struct ViewServer::State {
  explicit State(const fs::path& run_folder)
      : folder(run_folder), description(case_of_run(run_folder)), packer(description) {}

  bool is_live() const { return !fs::exists(folder / "result.json"); }

  Json run() {
    packer.add_frames(frame_files(folder));
    Json run = packer.head();
    run["live"] = is_live();
    run["frames"] = Json::array();
    for (std::size_t n = 0; n < packer.frames(); ++n) {
      Json entry = packer.entry(n);
      // The fields are part of the address, as the bytes depend on them.
      entry["url"] = fmt::format("frame/{}?fields={}", n, run.at("fields").size());
      run["frames"].push_back(std::move(entry));
    }
    if (fs::exists(folder / "series.csv")) {
      const SeriesTable series(folder / "series.csv", description);
      run["curves"] = viewer_curves(report_figures(series, description), series.numbers("time"),
                                    cut_time_of(series));
    }
    return run;
  }

  std::string page() {
    if (!is_live()) return report_page(folder, description, run());
    const std::string body = fmt::format(
        "<header>\n<h1>{}</h1>\n<p class=\"meta\">The run is in progress; this page follows "
        "it.</p>\n</header>\n{}{}",
        html::escape(description.title),
        html::section("kerf-viewer", "<p>This browser shows no moving pictures.</p>\n"),
        html::section("kerf-curves", ""));
    return html::page(description.title, body + viewer_script(run()));
  }

  void set_watch() {
    server.set_idle_interval(0, idle_microseconds);
    server.new_task_queue = [this] { return new WatchfulPool(server, ends); };
  }

  void refuse_others() {
    constexpr int forbidden = 403, longest_wait = 2;  // s, for the next bytes of a request
    server.set_read_timeout(longest_wait);
    server.set_pre_routing_handler([](const httplib::Request& request,
                                      httplib::Response& response) {
      if (may_ask(request)) return httplib::Server::HandlerResponse::Unhandled;
      response.status = forbidden;
      response.set_content("kerf view answers to 127.0.0.1 and localhost only.\n", "text/plain");
      return httplib::Server::HandlerResponse::Handled;
    });
  }

  void set_routes() {
    const auto answer = [this](const char* type, auto make) {
      return [this, type, make](const httplib::Request& request, httplib::Response& response) {
        const std::lock_guard hold(mutex);
        try {
          response.set_content(make(request), type);
        } catch (const std::exception& error) {
          response.status = 500;
          response.set_content(error.what(), "text/plain; charset=utf-8");
        }
      };
    };
    server.Get(path, answer("text/html; charset=utf-8", [this](const auto&) { return page(); }));
    server.Get(path + "run.json",
               answer("application/json", [this](const auto&) { return run().dump(); }));
    server.Get(path + R"(frame/(\d{1,9}))",
               answer("application/octet-stream", [this](const httplib::Request& request) {
                 return packer.pack(std::stoul(request.matches[1].str()));
               }));
  }

  fs::path folder;
  Case description;
  ViewerPacker packer;
  // Other users of this machine can reach the port but do not know it.
  const std::string path = fmt::format("/{}/", random_token());
  std::mutex mutex;  // one request at a time reads the folder
  std::atomic<bool> ends = false;
  httplib::Server server;
};

ViewServer::ViewServer(const fs::path& folder) : state_(std::make_unique<State>(folder)) {
  state_->refuse_others();
  state_->set_routes();
  state_->set_watch();
}
ViewServer::~ViewServer() = default;

const std::string& ViewServer::path() const {
  return state_->path;
}

int ViewServer::bind(int port) {
  constexpr const char* loopback = "127.0.0.1";
  if (port == 0) return state_->server.bind_to_any_port(loopback);
  if (!state_->server.bind_to_port(loopback, port))
    throw UserError(
        fmt::format("--port {}: the port is in use, or not allowed. Allowed: a free port "
                    "from 1 to 65535, or 0 for any. Choose another.",
                    port),
        exit_bad_input);
  return port;
}
void ViewServer::serve() {
  state_->server.listen_after_bind();
}
void ViewServer::stop() {
  state_->ends = true;
}

}  // namespace kerf
