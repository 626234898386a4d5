// SPDX-License-Identifier: Apache-2.0
// What each rank of a run would have to compute and to send, found without the ranks (docs/mpi.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf {

// How often a rank waits for others in one step, as its code calls parallel/ranks.hpp; docs/mpi.md
// compares the sums with calls of MPI that were counted.
struct StepWaits {
  int neighbours = 0;  // for the messages of the ranks beside it
  int sums = 0;        // for a few numbers of all ranks
  int lists = 0;       // for a list of each rank, which each sends to all

  StepWaits operator+(const StepWaits& other) const {
    return {neighbours + other.neighbours, sums + other.sums, lists + other.lists};
  }
  int all() const { return neighbours + sums + lists; }

  // Of particles: ghosts in the middle of the step; the time step, the balance with what is beside
  // its sums, and the newly moving ones; what rank 0 asks for.
  static StepWaits of_particles() { return {1, 5, 0}; }
  // Of solids: motion, the deformation of ghosts, contacts and accelerations; the number of
  // particles, the limit by waves and the particle that has it, twice; the viscous power and what
  // leaves.
  static StepWaits of_solid() { return {4, 4, 2}; }
  // Of bonds that may break: the fields of the test and what is marked; whether any may, and does.
  static StepWaits of_breaking() { return {2, 2, 0}; }
  // Of what a step with solids that break has now and then: new lists of neighbours, breaks,
  // waking, rows of series.csv. The mean of cases/tofu-5ms-standard.toml, less the others.
  static StepWaits of_changes() { return {2, 4, 6}; }
  // Of plastic flow: the tractions; its work.
  static StepWaits of_flow() { return {1, 0, 1}; }
  // Of softening, or of flaws: what they dissipate.
  static StepWaits of_loss() { return {0, 0, 1}; }
};

// The messages of a rank in a step, bytes, and the number of ranks with which it exchanges them.
struct RankMessages {
  double sent = 0.0, received = 0.0;
  int partners = 0;
};

struct RankLoad {
  double work = 0.0;                          // of its particles: a rigid one counts a tenth
  std::uint64_t particles = 0, ghosts = 0;    // at the start of the run
  std::uint64_t solid = 0, solid_ghosts = 0;  // particles whose bonds it computes, and copies
  double bonds = 0.0;                         // of these particles, from each end
  RankMessages messages;
};

struct RankLoads {
  std::vector<RankLoad> of;  // each rank
  StepWaits waits;           // in a step
  double solid_bytes = 0.0;  // memory for the whole solid, which each rank has
  std::uint64_t solid = 0;   // its particles
};

}  // namespace kerf
