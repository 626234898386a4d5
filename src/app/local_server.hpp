// SPDX-License-Identifier: Apache-2.0
// This header declares a server of pages for the browser of this machine alone: it listens at the
// loopback interface, below a path with a random token, and refuses requests of other sites.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace kerf {

// A request that is refused with a status of HTTP; all other errors of a handler have 500.
class RefusedRequest : public UserError {
 public:
  RefusedRequest(int status, const std::string& message) : UserError(message), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

namespace http_status {
inline constexpr int bad_request = 400, forbidden = 403, not_found = 404, conflict = 409;
}

class LocalServer {
 public:
  // Returns the content of the answer. `parts` are the groups of the pattern, from 1; [0] is the
  // whole path. Handlers may run at the same time.
  using Get = std::function<std::string(const std::vector<std::string>& parts)>;
  using Post = std::function<std::string(const std::string& body)>;

  // `command` names the command of the program in refusals.
  explicit LocalServer(std::string_view command);
  ~LocalServer();

  // Adds a page or file below path(). `pattern` is a regular expression.
  void get(const std::string& pattern, const char* type, Get make);
  // Adds an action that takes JSON and answers JSON. It is refused unless a page of this server
  // asks.
  void post(const std::string& pattern, Post act);

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
