// SPDX-License-Identifier: Apache-2.0
#include "verification/recording.hpp"

#include <chrono>
#include <cmath>

#include "analysis/cut_over.hpp"
#include "core/error.hpp"
#include "engine/device.hpp"
#include "model/case.hpp"
#include "verification/signal.hpp"

namespace kerf {

namespace {

void sample(std::vector<Signal>& signals, Moment moment, Recording& recording) {
  if (moment.time() < 0.0) return;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    recording.series[i].time.push_back(moment.time());
    recording.series[i].value.push_back(signals[i](moment));
  }
}

// Samples are taken at the start, at the first step past each multiple of the interval, and at the
// end, which the answer of a cut may bring early.
void record(const PlannedRun& run, const std::vector<const Check*>& checks,
            const VerifyProgress& progress, Recording& recording) {
  const Case description = run.description();
  const Case in_place = placed(description, run.placement);
  const auto simulation = make_simulation(in_place);
  Beginning beginning(description, *simulation, run.placement);
  std::vector<Signal> signals;
  for (const Check* check : checks) signals.push_back(make_signal(check->parameters, beginning));
  const double interval =
      run.sample_interval > 0.0 ? run.sample_interval : description.output.series_interval;
  sample(signals, Moment(beginning, *simulation), recording);
  double next = beginning.as_written.delay() > 0.0 ? 0.0 : interval;
  const bool may_be_over = may_end_early(description);
  bool is_over = false;
  while (!simulation->finished() && !is_over) {
    simulation->advance();
    Moment moment(beginning, *simulation);
    if (moment.time() < next && !simulation->finished()) continue;
    if (run.picture_time && !recording.image && moment.time() >= *run.picture_time)
      recording.image = moment.frame();
    next = interval * (std::floor(moment.time() / interval) + 1.0);
    progress(run.name, simulation->time() / in_place.time.end);
    is_over = may_be_over && is_cut_over(description, moment.cut_history(), moment.time());
    sample(signals, std::move(moment), recording);
  }
}

}  // namespace

Recording record_run(const PlannedRun& run, const std::vector<const Check*>& checks,
                     const VerifyProgress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Recording recording;
  recording.series.resize(checks.size());
  try {
    record(run, checks, progress, recording);
  } catch (const UserError& error) {
    recording.problem = error.what();
  }
  recording.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return recording;
}

}  // namespace kerf
