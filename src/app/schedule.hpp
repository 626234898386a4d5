// SPDX-License-Identifier: Apache-2.0
// When something is due: at the first step at or after each of its times. The loop never shortens a
// step to meet a time, so that what is written does not change what is computed.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace kerf {

class Schedule {
 public:
  // At these times, s, ascending.
  explicit Schedule(std::vector<double> times) : times_(std::move(times)) {}
  // At 0, interval, 2 interval, ...; never when the interval is 0.
  explicit Schedule(double interval) : interval_(interval) {}

  // True when one or more times have come since the last call.
  bool due(double now) {
    const std::uint64_t before = next_;
    if (interval_ > 0.0) {
      while (static_cast<double>(next_) * interval_ <= now) ++next_;
    } else {
      while (next_ < times_.size() && times_[next_] <= now) ++next_;
    }
    return next_ != before;
  }

  // How many times have passed; a resumed run goes on from there.
  std::uint64_t passed() const { return next_; }
  void restore(std::uint64_t passed) { next_ = passed; }

 private:
  std::vector<double> times_;
  double interval_ = 0.0;
  std::uint64_t next_ = 0;
};

}  // namespace kerf
