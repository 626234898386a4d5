// SPDX-License-Identifier: Apache-2.0
// A recording is a run of `kerf verify` with the signals of all its checks.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulation/frame.hpp"
#include "verification/plan.hpp"
#include "verification/series.hpp"

namespace kerf {

struct Recording {
  std::vector<TimeSeries> series;  // the signal of each check over time
  std::optional<Frame> image;      // at the time of the picture
  double seconds = 0.0;            // that the run took
  std::string problem;             // why it failed
  bool was_kept = false;           // made by an earlier kerf verify
};

// Receives the progress of a run, from 0 to 1.
using VerifyProgress = std::function<void(const std::string& run, double share)>;

// Makes a run and records the signals of `checks`.
Recording record_run(const PlannedRun& run, const std::vector<const Check*>& checks,
                     const VerifyProgress& progress);

}  // namespace kerf
