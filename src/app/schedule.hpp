// SPDX-License-Identifier: Apache-2.0
// This header declares a schedule: output is due at the first step at or after each of its times. A
// step is never shortened to meet a time, so that output does not change what is computed.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace kerf {

class Schedule {
 public:
  // The schedule has these times, s, in ascending order.
  explicit Schedule(std::vector<double> times) : times_(std::move(times)) {}
  // The schedule has the times 0, interval, 2 interval, ...; none if the interval is 0.
  explicit Schedule(double interval) : interval_(interval) {}

  // Returns true when one or more times have passed since the last call.
  bool due(double now) {
    const std::uint64_t before = next_;
    if (interval_ > 0.0) {
      while (static_cast<double>(next_) * interval_ <= now) ++next_;
    } else {
      while (next_ < times_.size() && times_[next_] <= now) ++next_;
    }
    return next_ != before;
  }

  // The number of times that have passed, from which a resumed run continues.
  std::uint64_t passed() const { return next_; }
  void restore(std::uint64_t passed) { next_ = passed; }

 private:
  std::vector<double> times_;
  double interval_ = 0.0;
  std::uint64_t next_ = 0;
};

}  // namespace kerf
