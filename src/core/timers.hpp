// SPDX-License-Identifier: Apache-2.0
// Wall time by named stage.
#pragma once

#include <chrono>
#include <vector>

#include "simulation/simulation.hpp"

namespace kerf {

class Timers {
 public:
  // Adds the time until the returned object dies to the stage.
  class Running {
   public:
    explicit Running(double& seconds) : seconds_(seconds), start_(Clock::now()) {}
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

   private:
    using Clock = std::chrono::steady_clock;
    double& seconds_;
    Clock::time_point start_;
  };

  Running stage(const char* name) {
    for (StageTime& stage : stages_)
      if (stage.name == name) return Running(stage.seconds);
    stages_.reserve(16);  // references into it stay valid
    stages_.push_back({name, 0.0});
    return Running(stages_.back().seconds);
  }
  std::vector<StageTime> times() const { return stages_; }

 private:
  std::vector<StageTime> stages_;
};

}  // namespace kerf
