// SPDX-License-Identifier: Apache-2.0
// This header declares the signals that ask a run to stop: Ctrl-C (SIGINT), SIGTERM, SIGHUP.
#pragma once

#include <csignal>

namespace kerf {

// While the object exists, the first signal is noted, so that the run ends in good order; a second
// one ends the process. Only one object may exist at a time.
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
