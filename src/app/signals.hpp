// SPDX-License-Identifier: Apache-2.0
// Requests to stop: Ctrl-C (SIGINT), SIGTERM, SIGHUP.
#pragma once

#include <csignal>

namespace kerf {

// While it lives, the first such signal is only noted, for the run to end in good order; a second
// one ends the process at once, as ever. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  int caught() const;  // the signal's number; 0 = none

 private:
  static constexpr int count_ = 3;
  struct sigaction before_[count_];
};

}  // namespace kerf
