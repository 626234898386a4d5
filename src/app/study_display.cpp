// SPDX-License-Identifier: Apache-2.0
#include "app/study_display.hpp"
#include "output/readable.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace kerf {

void StudyDisplay::show(const StudyProgress& now) {
  const auto time = Clock::now();
  const bool is_new_round = now.round != last_.round;
  if (is_new_round) {
    start_ = time;
    start_share_ = now.share;
  }
  const bool has_changed = is_new_round || now.ended != last_.ended;
  last_ = now;
  if (style_ == ProgressStyle::none) return;
  const std::string words = line(now, std::chrono::duration<double>(time - start_).count());
  if (style_ == ProgressStyle::bar) {
    bar_.show(now.share, words);
  } else if (has_changed) {
    fmt::print("{}\n", words);
    std::fflush(stdout);
  }
}

std::string StudyDisplay::line(const StudyProgress& now, double seconds) const {
  return fmt::format("{} of {} runs | at work {} | failed {} | left {}", now.ended, now.total,
                     now.at_work, now.failed,
                     duration_text(seconds_left(now, start_share_, seconds)));
}

}  // namespace kerf
