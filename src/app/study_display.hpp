// SPDX-License-Identifier: Apache-2.0
// This header declares the display of the progress of the runs of a study or a limit.
#pragma once

#include <chrono>
#include <string>

#include "app/progress.hpp"
#include "study/study_runs.hpp"

namespace kerf {

class StudyDisplay {
 public:
  explicit StudyDisplay(ProgressStyle style) : style_(style) {}

  // Shows the progress of the runs that are made at the same time: their number, those at work and
  // the time that is left.
  void show(const StudyProgress& now);
  void clear() { bar_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;

  std::string line(const StudyProgress& now, double seconds) const;

  ProgressStyle style_;
  Bar bar_;
  StudyProgress last_;
  Clock::time_point start_ = Clock::now();
  double start_share_ = 0.0;
};

}  // namespace kerf
