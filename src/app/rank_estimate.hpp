// SPDX-License-Identifier: Apache-2.0
// The time and the memory of a run of several ranks, estimated from what each rank would have
// (distributed/rank_load.hpp, docs/mpi.md).
#pragma once

#include "distributed/rank_load.hpp"

namespace kerf {

// What joins the ranks. The values are those of a network of 100 Gbit/s: Open MPI needs 1.9 us from
// one machine to another, and reaches nine tenths of the rate.
struct Network {
  double latency = 2e-6;    // s, of a short message
  double bandwidth = 1e10;  // bytes/s of each rank
};

// The run by one rank, of which the ranks take parts.
struct OneRank {
  int dimension = 3;
  double step_time = 0.0;   // s, mean over the run
  double steps = 0.0;       // of the run
  double memory = 0.0;      // bytes, for the particles
  double bond_share = 0.0;  // of the time, for bonds of solids
  double refinement = 1.0;  // particles of the case over those of the layout that was divided
};

struct RankEstimate {
  int ranks = 1;
  // Of the rank that has most: its own particles at the start, its ghosts; likewise those whose
  // bonds it computes.
  double particles = 0.0, ghosts = 0.0, solid = 0.0, solid_ghosts = 0.0;
  double imbalance = 1.0;   // work of the slowest over the mean, without ghosts
  double memory = 0.0;      // bytes, for the particles of the largest
  double bytes = 0.0;       // sent or received by a rank in a step, the most
  int partners = 0;         // with which a rank exchanges them, the most
  double compute = 0.0;     // s, of a step
  double messages = 0.0;    // s, of a step
  double step_time = 0.0;   // s
  double run_time = 0.0;    // s
  double speed_up = 1.0;    // over one rank
  double efficiency = 1.0;  // speed-up over ranks
};

RankEstimate estimate_ranks(const RankLoads& loads, const OneRank& one, const Network& network);

}  // namespace kerf
