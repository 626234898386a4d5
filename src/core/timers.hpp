// SPDX-License-Identifier: Apache-2.0
// Timers measures wall time by named stage.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace kerf {

struct StageTime {
  std::string name;
  double seconds = 0.0;
};

class Timers {
 public:
  // `synchronise` is called before the end of a stage is measured, because calls of loops on a GPU
  // return before the loops end.
  explicit Timers(void (*synchronise)() noexcept) : synchronise_(synchronise) {}

  // Adds the lifetime of the returned object to the stage.
  class Running {
   public:
    Running(double& seconds, void (*synchronise)() noexcept)
        : seconds_(seconds), synchronise_(synchronise), start_(Clock::now()) {}
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
      synchronise_();
      seconds_ += std::chrono::duration<double>(Clock::now() - start_).count();
    }

   private:
    using Clock = std::chrono::steady_clock;
    double& seconds_;
    void (*synchronise_)() noexcept;
    Clock::time_point start_;
  };

  Running stage(const char* name) {
    for (StageTime& stage : stages_)
      if (stage.name == name) return Running(stage.seconds, synchronise_);
    stages_.reserve(16);  // references into it stay valid
    stages_.push_back({name, 0.0});
    return Running(stages_.back().seconds, synchronise_);
  }
  std::vector<StageTime> times() const { return stages_; }

 private:
  void (*synchronise_)() noexcept;
  std::vector<StageTime> stages_;
};

}  // namespace kerf
