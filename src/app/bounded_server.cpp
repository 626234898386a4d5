// SPDX-License-Identifier: Apache-2.0
#include "app/bounded_server.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace kerf {

namespace {

// The bytes of a connection, of which a request may have a limited number.
class BoundedStream : public httplib::Stream {
 public:
  BoundedStream(socket_t socket, int read_wait, int write_wait)
      : socket_(socket), read_wait_(read_wait), write_wait_(write_wait) {}

  void begin_request() {
    taken_ = 0;
    line_length_ = 0;
    most_ = BoundedServer::longest_head;
  }
  // Waits for the first bytes of a request.
  bool has_bytes(int milliseconds) const { return next_ < end_ || is_ready(POLLIN, milliseconds); }

  bool is_readable() const override { return has_bytes(read_wait_); }
  bool is_writable() const override { return is_ready(POLLOUT, write_wait_); }

  ssize_t read(char* bytes, std::size_t size) override {
    if (taken_ >= most_) return -1;
    if (next_ == end_ && !fill()) return -1;
    const std::size_t count = std::min({size, end_ - next_, most_ - taken_});
    std::memcpy(bytes, buffer_.data() + next_, count);
    next_ += count;
    taken_ += count;
    look_for_end_of_head({bytes, count});
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* bytes, std::size_t size) override {
    return is_writable() ? ::send(socket_, bytes, size, MSG_NOSIGNAL) : -1;
  }
  // Only this machine reaches the server.
  void get_remote_ip_and_port(std::string& address, int& port) const override {
    address = "127.0.0.1";
    port = 0;
  }
  void get_local_ip_and_port(std::string& address, int& port) const override {
    get_remote_ip_and_port(address, port);
  }
  socket_t socket() const override { return socket_; }

 private:
  bool is_ready(short events, int milliseconds) const {
    pollfd state{socket_, events, 0};
    return ::poll(&state, 1, milliseconds) > 0;
  }
  bool fill() {
    if (!is_ready(POLLIN, read_wait_)) return false;
    const ssize_t count = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    next_ = 0;
    end_ = count > 0 ? static_cast<std::size_t>(count) : 0;
    return count > 0;
  }
  // After an empty line a body may follow, in chunks whose lengths take bytes too.
  void look_for_end_of_head(std::string_view bytes) {
    constexpr std::size_t most_of_chunks = 2 * BoundedServer::longest_body;
    if (most_ != BoundedServer::longest_head) return;
    for (const char byte : bytes) {
      if (byte == '\n' && line_length_ == 0 && taken_ > bytes.size() + 1)
        most_ = BoundedServer::longest_head + most_of_chunks;
      if (byte == '\n')
        line_length_ = 0;
      else if (byte != '\r')
        ++line_length_;
    }
  }

  socket_t socket_;
  int read_wait_, write_wait_;  // ms
  std::array<char, 4096> buffer_{};
  std::size_t next_ = 0, end_ = 0;           // of the bytes in the buffer that are not taken yet
  std::size_t taken_ = 0, line_length_ = 0;  // of the request, and of its line
  std::size_t most_ = BoundedServer::longest_head;
};

}  // namespace

BoundedServer::BoundedServer() {
  set_payload_max_length(longest_body);
  // By the default of the library several servers may share a port, each for some connections.
  set_socket_options([](socket_t socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
}

bool BoundedServer::process_and_close_socket(socket_t socket) {
  constexpr int second = 1000, slice = 50;  // ms
  BoundedStream stream(socket, static_cast<int>(read_timeout_sec_) * second,
                       static_cast<int>(write_timeout_sec_) * second);
  bool is_served = false;
  for (std::size_t left = keep_alive_max_count_; left > 0; --left) {
    int waited = 0;
    const int longest_wait = static_cast<int>(keep_alive_timeout_sec_) * second;
    while (svr_sock_ != INVALID_SOCKET && waited < longest_wait && !stream.has_bytes(slice))
      waited += slice;
    if (svr_sock_ == INVALID_SOCKET || waited >= longest_wait) break;
    stream.begin_request();
    bool is_closed = false;
    is_served = process_request(stream, left == 1, is_closed, nullptr);
    if (!is_served || is_closed) break;
  }
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
  return is_served;
}

}  // namespace kerf
