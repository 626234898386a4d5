// SPDX-License-Identifier: Apache-2.0
// What a user sees while a run goes on: a bar that renews itself on a terminal, lines elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "app/bar.hpp"
#include "measure/cut.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

struct ProgressNumbers {
  double time = 0.0;  // s
  double end = 0.0;   // s
  std::uint64_t step = 0;
  StepInfo last_step;
  CutState cut;               // of the last row of the series
  double energy_drift = 0.0;  // of the same
};

// "42.0% | t 12.6 ms | step 5120 | dt 2.5 us (acoustic (water)) | front 21.3 mm | ..."
std::string progress_line(const ProgressNumbers& numbers, double seconds_left);
// "1 h 05 min", "3 min 20 s", "12 s"; "?" when not yet known.
std::string duration_text(double seconds);

enum class ProgressStyle { none, lines, bar };
// A bar where standard output is a terminal.
ProgressStyle progress_style(bool quiet);

class Progress {
 public:
  explicit Progress(ProgressStyle style) : style_(style) {}

  // To be called after every step; shows something only now and then.
  void update(const ProgressNumbers& numbers);
  // A line of its own.
  void say(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;

  void follow_pace(double share, Clock::time_point now);

  ProgressStyle style_;
  Bar bar_;
  Clock::time_point shown_at_{};
  double shown_share_ = -1.0;
  // Where the pace is measured from; renewed, so that it follows a run whose steps grow dearer.
  Clock::time_point pace_start_{};
  double pace_share_ = -1.0;
  bool pace_settled_ = false;
  double pace_ = 0.0;  // share of the run per second of wall time, an average over past looks
};

}  // namespace kerf
