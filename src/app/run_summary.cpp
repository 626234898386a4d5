// SPDX-License-Identifier: Apache-2.0
// This file collects the numbers of a run for the terminal, the checkpoint and result.json.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "analysis/broken_bonds.hpp"
#include "analysis/cut_over.hpp"
#include "analysis/derived.hpp"
#include "app/run_loop.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"
#include "output/result.hpp"

namespace kerf {

const std::shared_ptr<const Frame>& RunLoop::shared_frame() {
  if (!frame_) frame_ = std::make_shared<const Frame>(simulation_->frame());
  return frame_;
}

double RunLoop::wall_time() const {
  return before_.wall_time + std::chrono::duration<double>(Clock::now() - started_).count();
}

std::vector<StageTime> RunLoop::stage_times() const {
  std::vector<StageTime> stages = before_.stage_times;
  for (const StageTime& stage : simulation_->stage_times()) {
    const auto known = std::find_if(stages.begin(), stages.end(), [&](const StageTime& other) {
      return other.name == stage.name;
    });
    if (known == stages.end())
      stages.push_back(stage);
    else
      known->seconds += stage.seconds;
  }
  // By name, as in the checkpoint: a run that was resumed has the order of one that was not.
  std::sort(stages.begin(), stages.end(),
            [](const StageTime& a, const StageTime& b) { return a.name < b.name; });
  return stages;
}

RunRecord RunLoop::record(bool finished) const {
  RunRecord record;
  record.case_name = settings_.case_name;
  record.finished = finished;
  record.wall_time = wall_time();
  record.frame_times = frames_.times();
  record.picture_times = pictures_.times();
  record.frames_due = frames_due_.passed();
  record.pictures_due = pictures_due_.passed();
  record.rows_due = rows_due_.passed();
  record.rows = series_.rows();
  record.row_time = row_time_;
  record.limits = limits_;
  record.stage_times = stage_times();
  record.most_stored = most_stored_;
  record.cut_history = cut_->history();
  record.cut_traces = cut_->traces();
  return record;
}

ProgressNumbers RunLoop::numbers() const {
  ProgressNumbers numbers;
  numbers.time = simulation_->time();
  numbers.end = expected_end(settings_.description, cut_->history());
  numbers.step = simulation_->step();
  numbers.last_step = simulation_->last_step();
  if (!cut_->history().empty()) numbers.cut = cut_->history().back();
  numbers.energy_drift = energy_drift_;
  return numbers;
}

// Measures the kerf in the last frame.
void RunLoop::measure(RunOutcome& outcome) {
  if (settings_.description.jets.empty()) return;
  const Case shifted = at_shift(settings_.description, simulation_->shifts());
  outcome.kerf = measure_kerf(cut_->workpiece(), frame(), kerf_conditions(shifted, outcome.cut));
  const int other = outcome.cut.cut_jet;
  if (other == 0) return;
  Case seen = shifted;
  std::swap(seen.jets.front(), seen.jets.at(static_cast<std::size_t>(other)));
  outcome.kerf_of_cut =
      measure_kerf(cut_->workpiece_along(other), frame(), kerf_conditions(seen, outcome.cut));
}

nlohmann::ordered_json RunLoop::result() {
  RunOutcome outcome;
  outcome.description = settings_.description;
  outcome.case_name = settings_.case_name;
  outcome.derived = derive(settings_.description);
  outcome.cut = cut_->summary();
  measure(outcome);
  outcome.loose = loose_;
  // The bonds of a later window of a travelling frame are not those of the first.
  outcome.has_broken_bonds =
      simulation_->shifts() > 0 ||
      broken_bond_sum(cut_->workpiece(), frame(), cut_->traces()) > broken_at_start_;
  outcome.stationary = stationary_;
  outcome.still_cutting = still_cutting(cut_->history());
  outcome.balance = simulation_->balance();
  outcome.most_stored = most_stored_;
  if (!cuts_nothing(outcome))
    outcome.exposure = exposure_of(settings_.description, cut_->history(), outcome.cut);
  outcome.time = simulation_->time();
  outcome.steps = simulation_->step();
  outcome.particles = simulation_->particles();
  outcome.pair_interactions = simulation_->pair_interactions();
  outcome.time_step_limits = limits_;
  outcome.wall_time = wall_time();
  outcome.device = settings_.device;
  outcome.threads = settings_.threads;
  outcome.stage_times = stage_times();
  outcome.frames = frames_.times().size();
  for (std::size_t i = 0; i < pictures_.times().size(); ++i)
    outcome.pictures.push_back({pictures_.file(i), pictures_.times()[i]});
  return result_of(outcome);
}

}  // namespace kerf
