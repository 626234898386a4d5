// SPDX-License-Identifier: Apache-2.0
// This header declares the state of the run loop in a checkpoint, besides that of the simulation,
// so that a resumed run gives the same results as one without a stop.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "analysis/cut.hpp"
#include "output/result.hpp"
#include "simulation/archive.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

struct RunRecord {
  std::string case_name;
  bool finished = false;
  double wall_time = 0.0;                                        // s, of all parts of the run
  std::vector<double> frame_times, picture_times;                // s, of the files written
  std::uint64_t frames_due = 0, pictures_due = 0, rows_due = 0;  // positions in the schedules
  std::uint64_t rows = 0;                                        // of series.csv
  double row_time = -1.0;                                        // s, of the last of them
  std::map<std::string, std::uint64_t> limits;  // number of steps that each limit set
  std::vector<StageTime> stage_times;           // of all parts of the run
  MostStored most_stored;
  std::vector<CutState> cut_history;
  std::vector<std::uint8_t> cut_traces;  // CutMonitor::traces()
};

Archive to_archive(const RunRecord& record);
// Throws UserError (exit_files) when something is missing.
RunRecord record_from(const Archive& archive);

}  // namespace kerf
