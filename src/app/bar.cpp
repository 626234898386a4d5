// SPDX-License-Identifier: Apache-2.0
#include "app/bar.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace kerf {
namespace {

constexpr int bar_cells = 24;

int terminal_width() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

void Bar::show(double share, const std::string& words) {
  const int filled = static_cast<int>(share * bar_cells);
  std::string bar;
  for (int i = 0; i < bar_cells; ++i) bar += i < filled ? "█" : "░";
  const int room = terminal_width() - bar_cells - 2;
  const std::string seen = room > 0 ? words.substr(0, static_cast<std::size_t>(room)) : "";
  fmt::print("\r{} {}\033[K", bar, seen);
  std::fflush(stdout);
  is_shown_ = true;
}

void Bar::clear() {
  if (!is_shown_) return;
  fmt::print("\r\033[K");
  std::fflush(stdout);
  is_shown_ = false;
}

}  // namespace kerf
