// SPDX-License-Identifier: Apache-2.0
// A run of the `standard` formulation whose stages can be called one by one, as often as one likes:
// none of them moves the run on. What each does is the engine's own (standard/standard.hpp).
#pragma once

#include <memory>

#include "simulation/simulation.hpp"

namespace kerf {

class StagedRun {
 public:
  virtual ~StagedRun() = default;

  virtual Simulation& simulation() = 0;

  virtual void find_neighbours() = 0;  // of particles in the order of their cells
  virtual void reorder() = 0;          // into that order, without the list
  virtual void compute_pair_forces() = 0;
  virtual void sum_over_bonds() = 0;  // deformation and forces of solids
  virtual void break_bonds() = 0;
  virtual void integrate() = 0;  // a step too short to be seen

  // Before a stage, to give it work; `settle` then puts the run into order again.
  virtual void scatter() = 0;     // into an order by chance
  virtual void pull_apart() = 0;  // whole again, then cracked after every eighth layer
  virtual void settle() = 0;
};

// Takes a few steps, so that nothing is as it was laid out.
std::unique_ptr<StagedRun> make_staged_run(const Case& description);

}  // namespace kerf
