// SPDX-License-Identifier: Apache-2.0
// result.json: the verdict of a run and its numbers, in SI units.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "measure/cut.hpp"
#include "measure/derived.hpp"
#include "measure/kerf.hpp"
#include "output/validity.hpp"
#include "simulation/ledger.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

// How a run ended.
struct RunOutcome {
  Case description;
  std::string case_name;
  DerivedNumbers derived;
  CutSummary cut;
  std::optional<Kerf> kerf;    // of runs with a jet
  bool still_cutting = false;  // the front was moving when the run ended
  Ledger ledger;
  double time = 0.0;  // s
  std::uint64_t steps = 0;
  std::size_t particles = 0;
  double pair_interactions = 0.0;
  std::map<std::string, std::uint64_t> time_step_limits;  // steps that each limit set
  double wall_time = 0.0;                                 // s, over all parts of the run
  int threads = 0;
  std::string device;  // its name
  std::vector<StageTime> stage_times;
};

// True when something broke and the front went deeper in the last tenth of the history.
bool still_cutting(const std::vector<CutState>& history);

// One sentence: did the jet cut through, and when, how deep it came, or that it broke nothing.
std::string verdict_of(const RunOutcome& outcome);

nlohmann::ordered_json result_of(const RunOutcome& outcome);

}  // namespace kerf
