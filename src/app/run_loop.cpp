// SPDX-License-Identifier: Apache-2.0
#include "app/run_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "analysis/broken_bonds.hpp"
#include "analysis/cut_over.hpp"
#include "core/error.hpp"
#include "core/version.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "output/solid_flags.hpp"
#include "report/report.hpp"

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
      observations_due_(settings_.description),
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
      if (settings_.existing == Existing::resume)
        tell(
            fmt::format("{} has no checkpoint to continue from: the run starts from the beginning.",
                        folder_.path().string()));
      return begin();
    }
    start_log();
    const bool is_continued = !settings_.continued_text.empty();
    const bool has_later_end =
        is_continued && settings_.continued_end < settings_.description.time.end;
    const Checkpoint checkpoint = read_checkpoint(
        folder_.checkpoint(), is_continued ? settings_.continued_text : settings_.case_text);
    using_checkpoint([&] { before_ = record_from(checkpoint.run); });
    if (has_later_end || !already_finished()) return resume(checkpoint.simulation);
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

// Makes the simulation and takes from the frame before the first step what the result needs.
void RunLoop::look_at_layout() {
  simulation_ = maker_(settings_.description);
  loose_ = loose_particles(settings_.description, frame());
  refuse_loose_bodies(settings_.description, loose_);
  cut_.emplace(settings_.description, frame());
  broken_at_start_ = broken_bond_sum(cut_->workpiece(), frame());
}

void RunLoop::begin() {
  look_at_layout();
  tell(fmt::format("{}: {} initial particles, results in {}", settings_.case_name,
                   simulation_->particles(), folder_.path().string()));
  for (const LooseParticles& body : loose_) tell(loose_sentence(settings_.description, body));
  series_.start();
  observe_due();
  write_due();
}

void RunLoop::advance(const std::function<bool()>& enough) {
  guarded([&] {
    while (!is_over() && !enough()) take_step();
  });
}

void RunLoop::take_step() {
  keep_before_end();
  simulation_->advance();
  frame_.reset();
  ++limits_[simulation_->last_step().limit];
  observe_due();
  write_due();
  const double interval = settings_.description.output.checkpoint_interval;
  const bool is_due = std::chrono::duration<double>(Clock::now() - saved_).count() >= interval;
  if (is_due && !simulation_->finished()) save_if_sound();
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
    const auto last =
        simulation_->finished() && before_end_ != nullptr ? before_end_ : saved_state(true);
    before_end_.reset();
    write_last();
    write_file(folder_.result(), result().dump(2) + "\n");
    write_report(folder_.path(), settings_.description);
    submit(last);
    writing_.wait();
    log_->info("finished after {}", duration_text(wall_time()));
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

void RunLoop::tell(const std::string& line) {
  log_->info(line);
  progress_.say(line);
}

}  // namespace kerf
