// SPDX-License-Identifier: Apache-2.0
// A run of `kerf verify`: made once, looked at by all of its checks.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulation/frame.hpp"
#include "verify/plan.hpp"
#include "verify/series.hpp"

namespace kerf {

struct Recording {
  std::vector<TimeSeries> series;  // the signal of each check over time
  std::optional<Frame> look;       // at the time of the picture
  double seconds = 0.0;            // that the run took
  std::string problem;             // why it broke down
  bool was_kept = false;           // made by an earlier kerf verify
};

// Told where a run is, from 0 to 1.
using VerifyProgress = std::function<void(const std::string& run, double share)>;

// Runs it. `checks` are those that look at it.
Recording record_run(const PlannedRun& run, const std::vector<const Check*>& checks,
                     const VerifyProgress& progress);

}  // namespace kerf
