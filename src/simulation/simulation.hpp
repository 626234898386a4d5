// SPDX-License-Identifier: Apache-2.0
// The interface of a run, independent of dimension, precision, formulation and device.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/timers.hpp"
#include "distributed/rank_load.hpp"
#include "simulation/archive.hpp"
#include "simulation/balance.hpp"
#include "simulation/field_span.hpp"
#include "simulation/frame.hpp"

namespace kerf {

struct Case;

// The last step and the limit that set it.
struct StepInfo {
  double dt = 0.0;                // s
  std::string limit;              // e.g. "acoustic (water)", "acceleration", "end of run"
  std::uint64_t limiting_id = 0;  // id of the particle that set it
};

class Simulation {
 public:
  virtual ~Simulation() = default;

  // Takes one step. Throws UserError (exit_run_failed), which names particle, time and cause, on a
  // value that is not a number, a runaway particle or a vanishing time step; the state is then
  // unusable.
  virtual void advance() = 0;

  virtual bool finished() const = 0;  // time() has reached the case's end
  virtual double time() const = 0;    // s
  virtual std::uint64_t step() const = 0;
  virtual std::size_t particles() const = 0;
  virtual StepInfo last_step() const = 0;
  virtual Frame frame() const = 0;
  // The frame without the columns that the verdict on a cut does not need (analysis/cut.hpp).
  virtual Frame frame_of_cut() const { return frame(); }
  virtual Balance balance() const = 0;
  // The fields of the particles where they are, in the order of the particles, which changes from
  // step to step; empty where the host cannot read them. Valid until the next step.
  virtual std::vector<FieldSpan> fields() const { return {}; }
  // Of a frame that travels with the nozzle: how often it was shifted, and the solid in its window
  // as laid out, with the ids that it has, also where particles have left.
  virtual std::uint64_t shifts() const { return 0; }
  virtual Frame layout() const { return frame(); }
  // The values of the probes of the case in their order: point -> pressure (Pa), velocity (m/s, 3);
  // plane -> force (N, 3).
  virtual std::vector<double> probe_values() const = 0;
  virtual double pair_interactions() const = 0;  // evaluated so far
  virtual double neighbours_per_particle() const = 0;
  virtual double bytes_per_particle() const = 0;  // fields and neighbour list, now
  virtual std::vector<StageTime> stage_times() const = 0;
  // What each of so many ranks would have of the present state of a run of one rank; nothing where
  // the build has no ranks, or they cannot divide the run (engine/lead.hpp).
  virtual RankLoads rank_loads(int /*count*/) const { return {}; }

  // A run that is restored from a saved state continues bit for bit.
  virtual void save(Archive& archive) const = 0;
  virtual void restore(const Archive& archive) = 0;
};

}  // namespace kerf
