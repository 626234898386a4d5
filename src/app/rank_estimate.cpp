// SPDX-License-Identifier: Apache-2.0
#include "app/rank_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

// Assumptions of the model; docs/mpi.md compares them with runs.
constexpr double work_of_ghost = 0.05;    // of a particle: it is packed, sorted and looked at
constexpr double undivided_time = 5e-9;   // s, of loops over the whole solid, for each particle
constexpr double time_of_entry = 2e-8;    // s, of the lists with an entry for each rank
constexpr double further_message = 0.25;  // of the latency, where several go at once
constexpr double bytes_of_sum = 64.0;     // of each rank

// The largest loads of a rank, scaled to the case, and their sums.
struct Largest {
  double work = 0.0, with_ghosts = 0.0, bonds = 0.0;
  double all_work = 0.0, all_bonds = 0.0, all_particles = 0.0, held = 0.0;
};

Largest largest_of(const RankLoads& loads, double surface, double volume, RankEstimate& estimate) {
  Largest largest;
  const auto raise = [](double& most, double value) { most = std::max(most, value); };
  for (const RankLoad& load : loads.of) {
    const double particles = volume * double(load.particles),
                 ghosts = surface * double(load.ghosts), work = volume * load.work;
    largest.all_work += work;
    largest.all_bonds += load.bonds;
    largest.all_particles += particles;
    raise(largest.work, work);
    raise(largest.with_ghosts, work + work_of_ghost * ghosts);
    raise(largest.bonds, load.bonds);
    raise(largest.held, particles + ghosts);
    raise(estimate.particles, particles);
    raise(estimate.ghosts, ghosts);
    raise(estimate.solid, volume * double(load.solid));
    raise(estimate.solid_ghosts, surface * double(load.solid_ghosts));
    raise(estimate.bytes, surface * std::max(load.messages.sent, load.messages.received));
    estimate.partners = std::max(estimate.partners, load.messages.partners);
  }
  return largest;
}

// Returns the time of the messages of a step, s. The messages to several ranks are under way at the
// same time; numbers of all ranks go through a tree.
double message_time(const RankLoads& loads, const RankEstimate& estimate, const Network& network) {
  const auto ranks = double(loads.of.size());
  if (loads.of.size() == 1) return 0.0;
  const double tree = network.latency * std::ceil(std::log2(ranks)),
               further = further_message * network.latency;
  const double beside = network.latency + further * std::max(0, estimate.partners - 1);
  return loads.waits.neighbours * beside + estimate.bytes / network.bandwidth +
         loads.waits.sums * (tree + ranks * bytes_of_sum / network.bandwidth) +
         loads.waits.lists * (tree + further * (ranks - 1.0)) +
         loads.waits.all() * ranks * time_of_entry;
}

double share(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

}  // namespace

RankEstimate estimate_ranks(const RankLoads& loads, const OneRank& one, const Network& network) {
  RankEstimate estimate;
  estimate.ranks = static_cast<int>(loads.of.size());
  const auto ranks = double(loads.of.size());
  const double volume = one.refinement,
               surface = std::pow(volume, (one.dimension - 1.0) / one.dimension);
  const Largest largest = largest_of(loads, surface, volume, estimate);
  const double bonds = largest.all_bonds > 0.0 ? one.bond_share : 0.0;
  const double of_bonds = bonds * share(largest.bonds, largest.all_bonds);
  estimate.imbalance = ranks * ((1.0 - bonds) * share(largest.work, largest.all_work) + of_bonds);
  const double solid = volume * double(loads.solid);
  estimate.compute =
      one.step_time * ((1.0 - bonds) * share(largest.with_ghosts, largest.all_work) + of_bonds) +
      (loads.of.size() > 1 ? undivided_time * solid : 0.0);
  estimate.messages = message_time(loads, estimate, network);
  estimate.step_time = estimate.compute + estimate.messages;
  const double of_solid = std::min(one.memory, volume * loads.solid_bytes);
  estimate.memory = of_solid + (one.memory - of_solid) * share(largest.held, largest.all_particles);
  estimate.run_time = one.steps * estimate.step_time;
  estimate.speed_up = share(one.step_time, estimate.step_time);
  estimate.efficiency = estimate.speed_up / ranks;
  return estimate;
}

}  // namespace kerf
