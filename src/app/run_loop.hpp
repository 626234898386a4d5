// SPDX-License-Identifier: Apache-2.0
// This header declares the loop of a run, from its first step or last checkpoint to its report.
// Output does not change what is computed; frames, pictures and checkpoints are written in the
// background.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "analysis/cut.hpp"
#include "analysis/observation_times.hpp"
#include "analysis/stationary_cut.hpp"
#include "app/progress.hpp"
#include "app/run_folder.hpp"
#include "app/run_log.hpp"
#include "app/run_record.hpp"
#include "app/schedule.hpp"
#include "app/signals.hpp"
#include "model/case.hpp"
#include "output/background.hpp"
#include "output/checkpoint.hpp"
#include "output/result.hpp"
#include "output/series.hpp"
#include "output/vtkhdf.hpp"
#include "report/picture.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

struct RunLoopSettings {
  Case description;
  // The stem of the case file, or the name with which a resumed run began; names frames and
  // pictures.
  std::string case_name;
  std::string case_text;  // of case.used.toml
  std::filesystem::path folder;
  Existing existing = Existing::refuse;
  bool quiet = false;
  LogFormat log_format = LogFormat::text;
  bool catches_signals = true;  // Ctrl-C, SIGTERM and SIGHUP stop the run in good order
  int threads = 0;              // for the results
  std::string device;           // for the results
  std::string resume_command;   // the command that continues the run
  // The case of the checkpoint and its end, s, where that or the output differs
  // (app/later_end.hpp).
  std::string continued_text{};
  double continued_end = 0.0;
};

// Returns the settings that follow from a case and the name of its file. An empty folder is
// out/<case>.
RunLoopSettings settings_of_case(Case description, const std::string& file,
                                 const std::filesystem::path& folder);

using SimulationMaker = std::function<std::unique_ptr<Simulation>(const Case&)>;

// How a run ended.
struct RunEnd {
  int signal = 0;  // 0 = the run is complete; otherwise the signal that stopped it
};

class RunLoop {
 public:
  RunLoop(RunLoopSettings settings, SimulationMaker maker);

  // Runs to the end. Throws UserError, whose message states how to continue; the files on the disk
  // remain valid.
  RunEnd run();

  // The parts of run(), for programs that look at the simulation between steps. They throw as it
  // does.
  bool start();  // or continues; false: the run in the folder has finished already
  void advance(const std::function<bool()>& enough);  // asked before each step
  bool is_over() const;  // at the end time, a while after the cut, or where that is stationary
  void save();           // a checkpoint, unless the run has broken down
  void finish();         // writes the last frame, the result and the report

  const RunLoopSettings& settings() const { return settings_; }
  const Simulation& simulation() const { return *simulation_; }
  const Frame& frame() { return *shared_frame(); }
  nlohmann::ordered_json result();  // as result.json would be now

 private:
  using Clock = std::chrono::steady_clock;
  struct SavedState {
    Checkpoint checkpoint;
    double time = 0.0;  // s
    std::uint64_t step = 0;
  };

  void guarded(const std::function<void()>& work);
  int caught() const;  // the signal that asks to stop; 0 = none
  void start_log();
  bool already_finished() const;
  void begin();
  void resume(const Archive& state);
  void keep_name();
  void look_at_layout();
  void leave_earlier_end();
  void check_state(const Archive& state) const;
  void using_checkpoint(const std::function<void()>& work) const;
  void take_step();
  void follow_window();  // measures in the window of a travelling frame
  void judge_motion();   // of a cut under a nozzle with which a frame travels
  void observe_due();    // the cut
  void observe_cut();
  bool is_observed() const;  // at this time
  void write_due();
  void write_row();
  void write_frame(bool as_frame, bool as_picture);
  void write_last();
  RunEnd stop(int signal);
  void save_if_sound();
  std::shared_ptr<const SavedState> saved_state(bool finished);
  void keep_before_end();
  void submit(std::shared_ptr<const SavedState> state);
  void measure(RunOutcome& outcome);

  const std::shared_ptr<const Frame>& shared_frame();
  RunRecord record(bool finished) const;
  ProgressNumbers numbers() const;
  double wall_time() const;
  std::vector<StageTime> stage_times() const;
  void tell(const std::string& line);

  RunLoopSettings settings_;
  SimulationMaker maker_;
  RunFolder folder_;
  std::shared_ptr<spdlog::logger> log_;
  std::optional<StopSignals> signals_;
  Progress progress_;
  Clock::time_point started_ = Clock::now();
  Clock::time_point saved_ = Clock::now();

  std::unique_ptr<Simulation> simulation_;
  std::optional<CutMonitor> cut_;
  ObservationTimes observations_due_;
  std::vector<LooseParticles> loose_;        // as laid out
  double broken_at_start_ = 0.0;             // analysis/broken_bonds.hpp
  std::uint64_t shifts_ = 0;                 // of the frame in which the cut is measured
  std::optional<StationaryCut> stationary_;  // at the last observation, where a frame travels
  std::shared_ptr<const Frame> frame_;       // of the current step, made on first use
  SeriesWriter series_;
  FrameWriter frames_;
  PictureWriter pictures_;
  Schedule frames_due_, pictures_due_, rows_due_;
  RunRecord before_;  // of the earlier parts of the run
  // The state before the last step, which is shortened to the end; none before that.
  std::shared_ptr<const SavedState> before_end_;
  std::map<std::string, std::uint64_t> limits_;
  double energy_drift_ = 0.0;
  MostStored most_stored_;    // of all observations
  double row_time_ = -1.0;    // s, of the last row of the series
  double saved_time_ = -1.0;  // s, of the last checkpoint; negative = none; set by `writing_`
  Background writing_;        // the last member, so that it ends before the others
};

}  // namespace kerf
