// SPDX-License-Identifier: Apache-2.0
// This header declares the display of the progress of a run: a bar on a terminal, else lines.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "analysis/cut.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

// A line of the terminal that is overwritten: a bar and words.
class Bar {
 public:
  Bar() = default;
  ~Bar() { clear(); }
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;

  void show(double share, const std::string& words);
  void clear();

 private:
  bool is_shown_ = false;
};

struct ProgressNumbers {
  double time = 0.0;  // s
  double end = 0.0;   // s, expected
  std::uint64_t step = 0;
  StepInfo last_step;
  CutState cut;               // at the last row of the series
  double energy_drift = 0.0;  // at the same row
};

// Returns "42.0% | t 12.6 ms | step 5120 | dt 2.5 us (acoustic (water)) | front 21.3 mm | ...".
std::string progress_line(const ProgressNumbers& numbers, double seconds_left);

enum class ProgressStyle { none, lines, bar };
// Returns the bar where standard output is a terminal.
ProgressStyle progress_style(bool quiet);

class Progress {
 public:
  explicit Progress(ProgressStyle style) : style_(style) {}

  // Is called after every step and shows the progress at intervals.
  void update(const ProgressNumbers& numbers);
  // Prints a line.
  void say(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;

  void follow_pace(double share, Clock::time_point now);

  ProgressStyle style_;
  Bar bar_;
  Clock::time_point shown_at_{};
  double shown_share_ = -1.0;
  // The start of the current measurement of the pace, which is repeated as the cost of steps
  // changes.
  Clock::time_point pace_start_{};
  double pace_share_ = -1.0;
  bool has_pace_ = false;
  double pace_ = 0.0;  // share of the run per second of wall time, a running average
};

}  // namespace kerf
