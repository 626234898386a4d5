// SPDX-License-Identifier: Apache-2.0
// This file saves the state of a run and continues from it.
#include <fmt/format.h>

#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "model/case.hpp"
#include "simulation/saved_state.hpp"

namespace kerf {

// Adds the file to the message of an error by its content, whose checksum is right.
void RunLoop::using_checkpoint(const std::function<void()>& work) const {
  const std::string file = folder_.checkpoint().string();
  try {
    work();
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}: {}", file, error.what()), error.exit_code());
  } catch (const std::logic_error& error) {
    throw UserError(
        fmt::format("{} is damaged ({}). Start the run again with --force.", file, error.what()),
        exit_files);
  }
}

void RunLoop::check_state(const Archive& state) const {
  Archive fresh;
  simulation_->save(fresh);
  check_saved_state(state, fresh, settings_.description);
}

// Keeps the name of the files that the earlier parts of the run have written: a case file that has
// another name since would leave half of the frames and pictures behind.
void RunLoop::keep_name() {
  const std::string& name = before_.case_name;
  if (name.empty() || name == settings_.case_name) return;
  using_checkpoint([&] {
    if (std::filesystem::path(name).filename() != name || name == "." || name == "..")
      throw std::logic_error("its name of the case is no name of a file");
  });
  tell(
      fmt::format("{}: the run keeps the name with which it began, {}", settings_.case_name, name));
  settings_.case_name = name;
  frames_ = FrameWriter(folder_.path(), name, legend_of(settings_.description));
  pictures_ = PictureWriter(folder_.path(), name, settings_.description);
}

void RunLoop::resume(const Archive& state) {
  keep_name();
  look_at_layout();
  using_checkpoint([&] {
    check_state(state);
    simulation_->restore(state);
    frame_.reset();
    follow_window();
    cut_->restore(before_.cut_history, before_.cut_traces, frame());
  });
  if (!settings_.continued_text.empty()) leave_earlier_end();
  saved_time_ = simulation_->time();
  judge_motion();
  series_.cut_back(simulation_->step(), before_.rows);
  frames_.restore(before_.frame_times);
  pictures_.restore(before_.picture_times);
  frames_due_.restore(before_.frames_due);
  pictures_due_.restore(before_.pictures_due);
  rows_due_.restore(before_.rows_due);
  limits_ = before_.limits;
  most_stored_ = before_.most_stored;
  row_time_ = before_.row_time;
  energy_drift_ = simulation_->balance().energy_drift();
  tell(fmt::format("{}: continuing from {:.6g} ms, step {}", settings_.case_name,
                   1e3 * simulation_->time(), simulation_->step()));
}

// Goes on beyond the end that the run had. Its last step was shortened to that.
void RunLoop::leave_earlier_end() {
  if (settings_.continued_end == settings_.description.time.end)
    return tell(settings_.case_name + ": rows and frames keep the times of output that they had");
  if (simulation_->time() >= settings_.continued_end)
    throw UserError(
        fmt::format(
            "{} is of the end of the run, {:.6g} ms, and has no state before the last step, "
            "which was shortened to it. Run the case with the later end by --force, or "
            "choose another folder with --out.",
            folder_.checkpoint().string(), 1e3 * settings_.continued_end),
        exit_files);
  write_file(folder_.used_case(), settings_.case_text);
  tell(fmt::format(
      "{}: the end is now {:.6g} ms instead of {:.6g} ms; rows and frames keep the "
      "intervals that they had",
      settings_.case_name, 1e3 * settings_.description.time.end, 1e3 * settings_.continued_end));
}

void RunLoop::save() {
  guarded([this] {
    save_if_sound();
    writing_.wait();
  });
}

// Saves the state, unless the energy balance shows that the run has broken down: what was saved
// before is kept then, so that a run goes on from a state that is safe.
void RunLoop::save_if_sound() {
  const Balance balance = simulation_->balance();
  if (balance.energy_is_sound()) return submit(saved_state(false));
  saved_ = Clock::now();
  tell(
      fmt::format("At {:.6g} ms the energy balance is off by {:.3g}%: this state is not saved, and "
                  "the last checkpoint is kept.",
                  1e3 * simulation_->time(), 100.0 * balance.energy_drift()));
}

std::shared_ptr<const RunLoop::SavedState> RunLoop::saved_state(bool finished) {
  writing_.wait();  // the checkpoint refers to the frames written
  series_.sync();   // and to its rows
  auto state = std::make_shared<SavedState>();
  simulation_->save(state->checkpoint.simulation);
  state->checkpoint.run = to_archive(record(finished));
  state->time = simulation_->time();
  state->step = simulation_->step();
  return state;
}

// Keeps the state before a step that may reach the end.
void RunLoop::keep_before_end() {
  constexpr double growth = 4.0;  // of one step over that before it, at most
  const double left = settings_.description.time.end - simulation_->time();
  if (left <= growth * simulation_->last_step().dt) before_end_ = saved_state(true);
}

void RunLoop::submit(std::shared_ptr<const SavedState> state) {
  saved_ = Clock::now();
  writing_.submit([this, state = std::move(state)] {
    write_checkpoint(folder_.checkpoint(), settings_.case_text, state->checkpoint);
    saved_time_ = state->time;
    log_->info("checkpoint at {:.6g} ms, step {}", 1e3 * state->time, state->step);
  });
}

}  // namespace kerf
