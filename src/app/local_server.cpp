// SPDX-License-Identifier: Apache-2.0
#include "app/local_server.hpp"

#include <fmt/format.h>

#include <atomic>
#include <random>

#include "app/bounded_server.hpp"

namespace kerf {

namespace {

constexpr int idle_microseconds = 50'000;
constexpr int longest_wait = 2;  // s, for the next bytes of a request
constexpr std::string_view scheme = "http://";

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

// Whether a header "Host" names this machine by itself. A page of another site can lead a name of
// its own to 127.0.0.1 and would read the answers by it (DNS rebinding).
bool is_this_machine(std::string_view host) {
  host = host.substr(0, host.find(':'));
  return host == "127.0.0.1" || host == "localhost";
}
bool may_ask(const httplib::Request& request) {
  const std::string origin = request.get_header_value("Origin");
  if (!origin.empty() && (origin.rfind(scheme, 0) != 0 ||
                          !is_this_machine(std::string_view(origin).substr(scheme.size()))))
    return false;
  return is_this_machine(request.get_header_value("Host"));
}

// Whether a page of this server asks for an action. A form of another page cannot send JSON, and
// another page of this machine has another port.
bool may_act(const httplib::Request& request) {
  return request.get_header_value("Origin") ==
             std::string(scheme) + request.get_header_value("Host") &&
         request.get_header_value("Content-Type").rfind("application/json", 0) == 0;
}

void refuse(httplib::Response& response, int status, const std::string& words) {
  response.status = status;
  response.set_content(words, "text/plain; charset=utf-8");
}

// Calls a handler and turns its errors into answers.
template <class Make>
void answer(httplib::Response& response, const char* type, const Make& make) {
  constexpr int failed = 500;
  try {
    response.set_content(make(), type);
  } catch (const RefusedRequest& error) {
    refuse(response, error.status(), error.what());
  } catch (const std::exception& error) {
    refuse(response, failed, error.what());
  }
}

}  // namespace

struct LocalServer::State {
  // Other users of this machine can reach the port but do not know it.
  const std::string path = fmt::format("/{}/", random_token());
  std::atomic<bool> ends = false;
  BoundedServer server;
};

LocalServer::LocalServer(std::string_view command) : state_(std::make_unique<State>()) {
  httplib::Server& server = state_->server;
  server.set_idle_interval(0, idle_microseconds);
  server.new_task_queue = [this] { return new WatchfulPool(state_->server, state_->ends); };
  server.set_read_timeout(longest_wait);
  // The token must not reach other sites with the address of the page.
  server.set_default_headers({{"Referrer-Policy", "same-origin"}, {"Cache-Control", "no-store"}});
  server.set_pre_routing_handler(
      [name = std::string(command)](const httplib::Request& request, httplib::Response& response) {
        if (may_ask(request)) return httplib::Server::HandlerResponse::Unhandled;
        refuse(response, http_status::forbidden,
               fmt::format("{} answers to 127.0.0.1 and localhost only.\n", name));
        return httplib::Server::HandlerResponse::Handled;
      });
}
LocalServer::~LocalServer() = default;

void LocalServer::get(const std::string& pattern, const char* type, Get make) {
  state_->server.Get(
      state_->path + pattern,
      [type, make = std::move(make)](const httplib::Request& request, httplib::Response& response) {
        answer(response, type, [&] {
          return make(std::vector<std::string>(request.matches.begin(), request.matches.end()));
        });
      });
}

void LocalServer::post(const std::string& pattern, Post act) {
  state_->server.Post(
      state_->path + pattern,
      [act = std::move(act)](const httplib::Request& request, httplib::Response& response) {
        if (!may_act(request))
          return refuse(response, http_status::forbidden,
                        "Only the page of this server may ask this.\n");
        answer(response, "application/json", [&] { return act(request.body); });
      });
}

const std::string& LocalServer::path() const {
  return state_->path;
}

int LocalServer::bind(int port) {
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
void LocalServer::serve() {
  state_->server.listen_after_bind();
}
void LocalServer::stop() {
  state_->ends = true;
}

}  // namespace kerf
