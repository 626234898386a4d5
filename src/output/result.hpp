// SPDX-License-Identifier: Apache-2.0
// The outcome of a run becomes result.json: the verdict and its numbers, in SI units.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/cut.hpp"
#include "analysis/derived.hpp"
#include "analysis/exposure.hpp"
#include "analysis/kerf.hpp"
#include "analysis/loose_particles.hpp"
#include "analysis/stationary_cut.hpp"
#include "model/case.hpp"
#include "output/metric_interval.hpp"
#include "output/validity.hpp"
#include "simulation/balance.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

// A picture that a run has written.
struct RunPicture {
  std::string file;   // in the folder of the run
  double time = 0.0;  // s

  static const MetricList<RunPicture>& metrics();
};

// What the solids of a run store by their bonds where this was the most, J (2D: J/m).
struct MostStored {
  double energy = 0.0;     // all of it
  double hourglass = 0.0;  // of it in the hourglass control

  // Takes a later balance where its solids store more.
  void observe(const Balance& balance) {
    if (balance.solid_energy() > energy) *this = {balance.solid_energy(), balance.hourglass};
  }
};

// All data of a run that result.json contains.
struct RunOutcome {
  Case description;
  std::string case_name;
  DerivedNumbers derived;
  CutSummary cut;
  std::optional<Kerf> kerf;           // of runs with a jet
  std::vector<LooseParticles> loose;  // of the bodies that have some
  // Whether a bond of the workpiece has broken; else it has at most softened.
  bool has_broken_bonds = true;
  // Of a nozzle that stands in the run and moves in the case, if its jet breaks something.
  std::optional<Exposure> exposure;
  std::optional<StationaryCut> stationary;  // where a frame travels with the nozzle
  bool still_cutting = false;               // when the run ended
  std::optional<Kerf> kerf_of_cut;  // along the jet whose way was cut, where that is not the first
  Balance balance;
  MostStored most_stored;  // of the rows of the run
  double time = 0.0;       // s
  std::uint64_t steps = 0;
  std::size_t particles = 0;
  double pair_interactions = 0.0;
  std::map<std::string, std::uint64_t> time_step_limits;  // steps that each limit set
  double wall_time = 0.0;                                 // s, over all parts of the run
  int threads = 0;
  std::string device;  // its name
  std::vector<StageTime> stage_times;
  std::size_t frames = 0;  // that were written
  std::vector<RunPicture> pictures;
  std::vector<MetricInterval> intervals;  // of a run with --converge

  // Return the metrics of the size of the run, of the computer, and of the files.
  static const MetricList<RunOutcome>& run_metrics();
  static const MetricList<RunOutcome>& file_metrics();
};

// Returns whether in the last tenth of the history of a workpiece that is not cut through solid in
// the way of the jets tore, or there was a cut and the front went deeper.
bool still_cutting(const std::vector<CutState>& history);
// Says what that means.
std::string still_cutting_sentence(const RunOutcome& outcome);
// Returns whether no bond of the workpiece has broken and nothing has come off; it may have
// softened.
bool breaks_nothing(const RunOutcome& outcome);
// Returns whether what has broken, if anything, opens no path from the face (CutState::cut_depth).
bool cuts_nothing(const RunOutcome& outcome);

// Returns one sentence: whether and when the jet cut through, its depth, or that nothing broke.
std::string verdict_of(const RunOutcome& outcome);

nlohmann::ordered_json result_of(const RunOutcome& outcome);

}  // namespace kerf
