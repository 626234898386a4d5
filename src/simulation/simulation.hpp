// SPDX-License-Identifier: Apache-2.0
// The face of a run, whatever its dimension, precision, formulation and backend.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "simulation/archive.hpp"
#include "simulation/frame.hpp"
#include "simulation/ledger.hpp"

namespace kerf {

// The step that was taken, or would be taken next, and the limit that set it.
struct StepInfo {
  double dt = 0.0;                // s
  std::string limit;              // e.g. "acoustic (water)", "acceleration", "end of run"
  std::uint64_t limiting_id = 0;  // id of the particle that set it
};

struct StageTime {
  std::string name;
  double seconds = 0.0;
};

class Simulation {
 public:
  virtual ~Simulation() = default;

  // Takes one step. Throws UserError (exit_run_failed) on a NaN, a runaway particle or a time step
  // gone to zero, naming particle, time and cause; the state is then unusable.
  virtual void advance() = 0;

  virtual bool finished() const = 0;  // time() has reached the case's end
  virtual double time() const = 0;    // s
  virtual std::uint64_t step() const = 0;
  virtual std::size_t particles() const = 0;
  virtual StepInfo last_step() const = 0;
  virtual Frame frame() const = 0;
  virtual Ledger ledger() const = 0;
  // Values of the case's probes in order: point -> pressure (Pa), velocity (m/s, 3);
  // plane -> force (N, 3).
  virtual std::vector<double> probe_values() const = 0;
  virtual double pair_interactions() const = 0;  // evaluated so far
  virtual double neighbours_per_particle() const = 0;
  virtual double bytes_per_particle() const = 0;  // fields and neighbour list, now
  virtual std::vector<StageTime> stage_times() const = 0;

  // Everything that `restore` needs to go on bitwise as if never stopped.
  virtual void save(Archive& archive) const = 0;
  virtual void restore(const Archive& archive) = 0;
};

// Builds the run a case describes, on the device of this process (exec/device.hpp). Throws
// UserError when the case cannot be built.
std::unique_ptr<Simulation> make_simulation(const Case& description);

// Threads used by all runs of this process; 0 = every core.
void set_threads(int threads);

}  // namespace kerf
