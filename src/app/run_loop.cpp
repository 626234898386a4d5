// SPDX-License-Identifier: Apache-2.0
#include "app/run_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "analysis/cut_over.hpp"
#include "core/error.hpp"
#include "core/version.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "output/checkpoint.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "report/report.hpp"
#include "simulation/saved_state.hpp"

namespace kerf {
namespace {

const char* signal_name(int signal) {
  switch (signal) {
    case SIGINT:
      return "Ctrl-C (SIGINT)";
    case SIGTERM:
      return "SIGTERM";
    default:
      return "SIGHUP";
  }
}

}  // namespace

RunLoopSettings settings_of_case(Case description, const std::string& file,
                                 const std::filesystem::path& folder) {
  RunLoopSettings settings;
  settings.case_name = std::filesystem::path(file).stem().string();
  settings.case_text = write_used(description);
  settings.folder = folder.empty() ? default_folder(file) : folder;
  settings.description = std::move(description);
  return settings;
}

RunLoop::RunLoop(RunLoopSettings settings, SimulationMaker maker)
    : settings_(std::move(settings)),
      maker_(std::move(maker)),
      folder_(settings_.folder, settings_.case_text, settings_.existing),
      progress_(progress_style(settings_.quiet)),
      series_(folder_.series(), settings_.description),
      frames_(folder_.path(), settings_.case_name, legend_of(settings_.description)),
      pictures_(folder_.path(), settings_.case_name, settings_.description),
      frames_due_(settings_.description.output.frame_times),
      pictures_due_(settings_.description.output.picture_times),
      rows_due_(settings_.description.output.series_interval) {
  if (settings_.catches_signals) signals_.emplace();
}

RunEnd RunLoop::run() {
  if (!start()) return {};
  advance([this] { return caught() != 0; });
  RunEnd end;
  guarded([&] {
    if (!is_over()) end = stop(caught());
  });
  if (end.signal == 0) finish();
  return end;
}

int RunLoop::caught() const {
  return signals_ ? signals_->caught() : 0;
}

// Adds to the message of an error how to continue.
void RunLoop::guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const UserError& error) {
    std::string message = error.what();
    try {
      writing_.wait();
    } catch (const UserError&) {  // the first error is reported
    }
    if (saved_time_ >= 0.0)
      message += fmt::format(
          " The run is saved up to {:.6g} ms, where its energy balance was sound; continue from "
          "there with: {}",
          1e3 * saved_time_, settings_.resume_command);
    if (log_) log_->error(message);
    throw UserError(message, error.exit_code());
  }
}

bool RunLoop::start() {
  bool has_steps = true;
  guarded([&] {
    if (!folder_.has_checkpoint()) {
      write_file(folder_.used_case(), settings_.case_text);
      keep_meshes(settings_.description, folder_.path());
      start_log();
      return begin();
    }
    start_log();
    const Checkpoint checkpoint = read_checkpoint(folder_.checkpoint(), settings_.case_text);
    using_checkpoint([&] { before_ = record_from(checkpoint.run); });
    if (!already_finished()) return resume(checkpoint.simulation);
    has_steps = false;
    progress_.say(
        fmt::format("This run has finished already; its report is {}", folder_.report().string()));
  });
  return has_steps;
}

void RunLoop::start_log() {
  log_ = open_log(folder_.path(), settings_.log_format);
  log_->info("kerf {}, {}, {} threads, {}: {}", program_version, compiler_name(), settings_.threads,
             settings_.device, settings_.description.title);
}

// A result that is damaged is made again.
bool RunLoop::already_finished() const {
  return before_.finished && std::filesystem::exists(folder_.result()) &&
         std::filesystem::exists(folder_.report()) &&
         nlohmann::json::accept(read_file(folder_.result()));
}

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

void RunLoop::begin() {
  simulation_ = maker_(settings_.description);
  cut_.emplace(settings_.description, frame());
  tell(fmt::format("{}: {} initial particles, results in {}", settings_.case_name,
                   simulation_->particles(), folder_.path().string()));
  series_.start();
  write_due();
}

void RunLoop::check_state(const Archive& state) const {
  Archive fresh;
  simulation_->save(fresh);
  check_saved_state(state, fresh, settings_.description);
}

void RunLoop::resume(const Archive& state) {
  simulation_ = maker_(settings_.description);
  cut_.emplace(settings_.description, frame());
  using_checkpoint([&] {
    check_state(state);
    simulation_->restore(state);
    frame_.reset();
    follow_window();
    cut_->restore(before_.cut_history, before_.cut_traces, frame());
  });
  saved_time_ = simulation_->time();
  judge_motion();
  series_.cut_back(simulation_->step(), before_.rows);
  frames_.restore(before_.frame_times);
  pictures_.restore(before_.picture_times);
  frames_due_.restore(before_.frames_due);
  pictures_due_.restore(before_.pictures_due);
  rows_due_.restore(before_.rows_due);
  limits_ = before_.limits;
  if (!before_.cut_history.empty()) row_time_ = before_.cut_history.back().time;
  energy_drift_ = simulation_->balance().energy_drift();
  tell(fmt::format("{}: continuing from {:.6g} ms, step {}", settings_.case_name,
                   1e3 * simulation_->time(), simulation_->step()));
}

void RunLoop::advance(const std::function<bool()>& enough) {
  guarded([&] {
    while (!is_over() && !enough()) take_step();
  });
}

void RunLoop::take_step() {
  simulation_->advance();
  frame_.reset();
  ++limits_[simulation_->last_step().limit];
  write_due();
  const double interval = settings_.description.output.checkpoint_interval;
  if (std::chrono::duration<double>(Clock::now() - saved_).count() >= interval) save_if_sound();
  progress_.update(numbers());
}

// The history of the cut is part of checkpoints, so that a resumed run ends with the same step.
bool RunLoop::is_over() const {
  if (simulation_->finished()) return true;
  if (stationary_ && stationary_->reached && settings_.description.time.stop == RunStop::stationary)
    return true;
  return is_cut_over(settings_.description, cut_->history(), simulation_->time());
}

void RunLoop::finish() {
  guarded([this] {
    write_last();
    write_file(folder_.result(), result().dump(2) + "\n");
    write_report(folder_.path(), settings_.description);
    save_checkpoint(true);
    writing_.wait();
    log_->info("finished after {}", duration_text(wall_time()));
  });
}

void RunLoop::save() {
  guarded([this] {
    save_if_sound();
    writing_.wait();
  });
}

RunEnd RunLoop::stop(int signal) {
  save_if_sound();
  writing_.wait();
  const std::string on = saved_time_ < 0.0 ? "Nothing is saved."
                                           : fmt::format(
                                                 "The run is saved up to {:.6g} ms. "
                                                 "Continue with: {}",
                                                 1e3 * saved_time_, settings_.resume_command);
  tell(fmt::format("Stopped by {} at {:.6g} ms. {}", signal_name(signal), 1e3 * simulation_->time(),
                   on));
  return {signal};
}

// Saves the state, unless the energy balance shows that the run has broken down: what was saved
// before is kept then, so that a run goes on from a state that is safe.
void RunLoop::save_if_sound() {
  const Balance balance = simulation_->balance();
  if (balance.energy_is_sound()) return save_checkpoint(false);
  saved_ = Clock::now();
  tell(
      fmt::format("At {:.6g} ms the energy balance is off by {:.3g}%: this state is not saved, and "
                  "the last checkpoint is kept.",
                  1e3 * simulation_->time(), 100.0 * balance.energy_drift()));
}

void RunLoop::save_checkpoint(bool finished) {
  writing_.wait();  // the checkpoint refers to the frames written
  series_.sync();   // and to its rows
  auto checkpoint = std::make_shared<Checkpoint>();
  simulation_->save(checkpoint->simulation);
  checkpoint->run = to_archive(record(finished));
  saved_ = Clock::now();
  writing_.submit([this, checkpoint, time = simulation_->time(), step = simulation_->step()] {
    write_checkpoint(folder_.checkpoint(), settings_.case_text, *checkpoint);
    saved_time_ = time;
    log_->info("checkpoint at {:.6g} ms, step {}", 1e3 * time, step);
  });
}

void RunLoop::tell(const std::string& line) {
  log_->info(line);
  progress_.say(line);
}

}  // namespace kerf
