// SPDX-License-Identifier: Apache-2.0
// This file does what is due after a step: it observes the cut and writes rows of the series,
// frames and pictures.
#include <fmt/format.h>

#include <algorithm>

#include "app/run_loop.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"

namespace kerf {

bool RunLoop::is_observed() const {
  return !cut_->history().empty() && cut_->history().back().time == simulation_->time();
}

void RunLoop::observe_due() {
  const auto& history = cut_->history();
  const bool is_first = history.empty() && observations_due_.has_own();
  if (is_first ||
      (!history.empty() && observations_due_.is_due(simulation_->time(), history.back().time)))
    observe_cut();
}

void RunLoop::observe_cut() {
  const Balance balance = simulation_->balance();
  follow_window();
  cut_->observe(frame_ ? *frame_ : simulation_->frame_of_cut(), balance.impulse_water);
  judge_motion();
  most_stored_.observe(balance);
}

// At the end all output up to the end is due, in spite of the rounding of the sum of all steps.
void RunLoop::write_due() {
  const double now = simulation_->finished()
                         ? std::max(simulation_->time(), settings_.description.time.end)
                         : simulation_->time();
  if (rows_due_.due(now)) write_row();
  const bool is_frame_due = frames_due_.due(now), is_picture_due = pictures_due_.due(now);
  if (is_frame_due || is_picture_due) write_frame(is_frame_due, is_picture_due);
}

void RunLoop::write_frame(bool as_frame, bool as_picture) {
  writing_.submit([this, as_frame, as_picture, frame = shared_frame()] {
    if (as_frame) {
      frames_.write(*frame);
      log_->info("frame {} at {:.6g} ms", frames_.times().size() - 1, 1e3 * frame->time);
    }
    if (as_picture) pictures_.write(*frame);
  });
}

// Rows between the observations of a cut leave no trace in its history.
void RunLoop::write_row() {
  if (!observations_due_.has_own() && !is_observed()) observe_cut();
  SeriesSample sample;
  sample.time = simulation_->time();
  sample.step = simulation_->step();
  sample.particles = simulation_->particles();
  sample.last_step = simulation_->last_step();
  sample.balance = simulation_->balance();
  follow_window();
  sample.cut = is_observed() ? cut_->history().back()
                             : cut_->state_at(frame_ ? *frame_ : simulation_->frame_of_cut(),
                                              sample.balance.impulse_water);
  sample.probes = simulation_->probe_values();
  series_.append(sample);
  energy_drift_ = sample.balance.energy_drift();
  row_time_ = sample.time;
}

void RunLoop::follow_window() {
  if (simulation_->shifts() == shifts_) return;
  shifts_ = simulation_->shifts();
  cut_->follow(at_shift(settings_.description, shifts_), simulation_->layout());
}

void RunLoop::judge_motion() {
  if (!travelling_frame(settings_.description)) return;
  const bool was_reached = stationary_ && stationary_->reached;
  stationary_ = stationary_cut(settings_.description, cut_->history());
  if (stationary_->reached && !was_reached)
    tell(fmt::format("The cut is stationary at {:.6g} ms, after {:.6g} mm of travel.",
                     1e3 * simulation_->time(), 1e3 * stationary_->travelled));
}

void RunLoop::write_last() {
  const double time = simulation_->time();
  const auto missing = [time](const std::vector<double>& times) {
    return times.empty() || times.back() != time;
  };
  if (!is_observed()) observe_cut();
  if (row_time_ != time) write_row();
  writing_.wait();
  write_frame(missing(frames_.times()), missing(pictures_.times()));
  writing_.wait();
}

}  // namespace kerf
