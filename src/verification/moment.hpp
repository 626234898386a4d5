// SPDX-License-Identifier: Apache-2.0
// A moment gives the state of a run at one instant to the signals and computes each part when it is
// first used.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/cut.hpp"
#include "model/case.hpp"
#include "simulation/simulation.hpp"
#include "verification/placement.hpp"

namespace kerf {

// The data that all moments of a run share.
struct Beginning {
  // `simulation` is that of the case `of` as it is placed.
  Beginning(const Case& of, const Simulation& simulation, const Placement& placement = {})
      : description(of),
        as_written(of, placement),
        frame(as_written.frame(simulation.frame())),
        cut_monitor(of, frame) {}

  Case description;  // as it is written
  PlacementInverse as_written;
  Frame frame;  // before the first step; its rows and those of later frames differ
  CutMonitor cut_monitor;
};

class Moment {
 public:
  Moment(Beginning& beginning, const Simulation& simulation)
      : beginning_(beginning), simulation_(simulation) {}

  // s, of the case as it is written
  double time() const { return simulation_.time() - beginning_.as_written.delay(); }

  const Frame& frame() {
    if (!frame_) frame_ = beginning_.as_written.frame(simulation_.frame());
    return *frame_;
  }
  const std::vector<double>& probe_values() {
    if (!probes_) probes_ = beginning_.as_written.probe_values(simulation_.probe_values());
    return *probes_;
  }
  const Balance& balance() {
    if (!balance_) balance_ = beginning_.as_written.balance(simulation_.balance());
    return *balance_;
  }
  const CutState& cut() {
    if (!cut_) cut_ = beginning_.cut_monitor.observe(frame());
    return *cut_;
  }
  // The states of the cut at this moment and at those before it that were asked for one.
  const std::vector<CutState>& cut_history() {
    cut();
    return beginning_.cut_monitor.history();
  }
  CutSummary cut_summary() {
    cut();
    return beginning_.cut_monitor.summary();
  }

 private:
  Beginning& beginning_;
  const Simulation& simulation_;
  std::optional<Frame> frame_;
  std::optional<std::vector<double>> probes_;
  std::optional<Balance> balance_;
  std::optional<CutState> cut_;
};

}  // namespace kerf
