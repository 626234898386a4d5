// SPDX-License-Identifier: Apache-2.0
#include "app/progress.hpp"
#include "output/readable.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace kerf {

namespace {

constexpr int bar_cells = 24;

int terminal_width() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

constexpr double bar_pause = 0.1;    // s, between two updates of the bar
constexpr double line_pause = 5.0;   // s, between two lines at most
constexpr double line_share = 0.02;  // share of the run between two lines at most
constexpr double pace_window = 3.0;  // s, between two measurements of the pace
constexpr double pace_weight = 0.4;  // weight of the newest measurement

double seconds_between(std::chrono::steady_clock::time_point from,
                       std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

void Bar::show(double share, const std::string& words) {
  const int filled = static_cast<int>(share * bar_cells);
  std::string bar;
  for (int i = 0; i < bar_cells; ++i) bar += i < filled ? "█" : "░";
  const int room = terminal_width() - bar_cells - 2;
  const std::string shown = room > 0 ? words.substr(0, static_cast<std::size_t>(room)) : "";
  fmt::print("\r{} {}\033[K", bar, shown);
  std::fflush(stdout);
  is_shown_ = true;
}

void Bar::clear() {
  if (!is_shown_) return;
  fmt::print("\r\033[K");
  std::fflush(stdout);
  is_shown_ = false;
}

std::string progress_line(const ProgressNumbers& numbers, double seconds_left) {
  const double share = numbers.end > 0.0 ? std::min(1.0, numbers.time / numbers.end) : 1.0;
  return fmt::format(
      "{:5.1f}% | left {} | t {:.4g} ms | step {} | dt {:.3g} us, {} | front {:.1f} mm | "
      "fractured {:.2f}% | energy {:+.2f}%",
      100.0 * share, duration_text(seconds_left), 1e3 * numbers.time, numbers.step,
      1e6 * numbers.last_step.dt, numbers.last_step.limit, 1e3 * numbers.cut.front_depth,
      100.0 * numbers.cut.fractured_fraction, 100.0 * numbers.energy_drift);
}

ProgressStyle progress_style(bool quiet) {
  if (quiet) return ProgressStyle::none;
  return isatty(STDOUT_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::lines;
}

void Progress::update(const ProgressNumbers& numbers) {
  if (style_ == ProgressStyle::none) return;
  const auto now = Clock::now();
  const double share = numbers.end > 0.0 ? std::min(1.0, numbers.time / numbers.end) : 1.0;
  if (pace_share_ < 0.0) {
    pace_share_ = shown_share_ = share;
    pace_start_ = shown_at_ = now;
    return;
  }
  const double pause = seconds_between(shown_at_, now);
  const bool time_to_show = style_ == ProgressStyle::bar
                                ? pause >= bar_pause
                                : pause >= line_pause || share - shown_share_ >= line_share;
  if (!time_to_show) return;
  shown_at_ = now;
  shown_share_ = share;
  follow_pace(share, now);
  const double left = pace_ > 0.0 ? (1.0 - share) / pace_ : std::numeric_limits<double>::infinity();
  const std::string line = progress_line(numbers, left);
  if (style_ == ProgressStyle::bar)
    bar_.show(share, line);
  else
    say(line);
}

void Progress::follow_pace(double share, Clock::time_point now) {
  const double elapsed = seconds_between(pace_start_, now);
  if (elapsed <= 0.0) return;
  const double newest = (share - pace_share_) / elapsed;
  if (!has_pace_) pace_ = newest;
  if (elapsed < pace_window) return;
  if (has_pace_) pace_ += pace_weight * (newest - pace_);
  has_pace_ = true;
  pace_share_ = share;
  pace_start_ = now;
}

void Progress::say(const std::string& line) {
  bar_.clear();
  if (style_ == ProgressStyle::none) return;
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace kerf
