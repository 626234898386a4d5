// SPDX-License-Identifier: Apache-2.0
// This header declares a server of HTTP that bounds what it keeps of a request: httplib itself
// bounds the length of a body that is announced, but not that of the request line and the headers.
#pragma once

#include <httplib.h>

#include <cstddef>

namespace kerf {

class BoundedServer : public httplib::Server {
 public:
  static constexpr std::size_t longest_head = 64 << 10;  // bytes, of the request line and headers
  static constexpr std::size_t longest_body = 4 << 20;   // bytes

  BoundedServer();

 private:
  // Serves the requests of a connection. One that is too long is answered with 400, or not at all,
  // and ends the connection.
  bool process_and_close_socket(socket_t socket) override;
};

}  // namespace kerf
