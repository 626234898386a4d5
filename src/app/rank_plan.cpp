// SPDX-License-Identifier: Apache-2.0
#include "app/rank_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/executor_options.hpp"
#include "core/error.hpp"
#include "engine/device.hpp"
#include "engine/lead.hpp"
#include "output/readable.hpp"
#include "parallel/ranks.hpp"

namespace kerf {

namespace {

constexpr double most_laid_out = 5e5;  // particles, which take some ten seconds
constexpr double paying = 0.5;         // efficiency

std::unique_ptr<Simulation> made(const Case& description) {
  try {
    return make_simulation(description);
  } catch (const UserError&) {
    return nullptr;
  }
}

// Returns the case with as many particles as are laid out. A lattice may happen to have particles
// on a symmetry plane; then another one is tried.
std::unique_ptr<Simulation> lay_out(const Case& description, double particles) {
  if (particles <= most_laid_out) return make_simulation(description);
  const double factor = std::pow(particles / most_laid_out, 1.0 / description.dimension);
  for (const double stretch : {1.0, 1.1, 1.21})
    if (auto layout = made(with_coarser_particles(description, stretch * factor))) return layout;
  return make_simulation(with_coarser_particles(description, 1.33 * factor));
}

// Returns 1, 2, 4 ... and the number itself.
std::vector<int> numbers_up_to(int ranks) {
  std::vector<int> numbers;
  for (int count = 1; count < ranks; count *= 2) numbers.push_back(count);
  numbers.push_back(ranks);
  return numbers;
}

nlohmann::ordered_json json_of(const RankEstimate& estimate) {
  return {{"ranks", estimate.ranks},
          {"particles", estimate.particles},
          {"ghosts", estimate.ghosts},
          {"solid", estimate.solid},
          {"solid_ghosts", estimate.solid_ghosts},
          {"imbalance", estimate.imbalance},
          {"memory", estimate.memory},
          {"bytes_per_step", estimate.bytes},
          {"partners", estimate.partners},
          {"compute_time", estimate.compute},
          {"message_time", estimate.messages},
          {"step_time", estimate.step_time},
          {"run_time", estimate.run_time},
          {"speed_up", estimate.speed_up},
          {"efficiency", estimate.efficiency}};
}

}  // namespace

int RankPlan::paying_ranks() const {
  int most = 1;
  for (const RankEstimate& estimate : estimates)
    if (estimate.efficiency >= paying) most = std::max(most, estimate.ranks);
  return most;
}

std::string RankPlan::text() const {
  std::string text = fmt::format(
      "\nRanks of {} {}, {} and {} between them\n  {:>6} {:>10} {:>10} {:>9} {:>9} {:>10} {:>9} "
      "{:>11} {:>8} {:>10}\n",
      threads, threads == 1 ? "thread" : "threads", readable(network.latency, "s"),
      readable(network.bandwidth, "B/s"), "ranks", "particles", "ghosts", "imbalance", "memory",
      "sent", "step", "run", "speed-up", "efficiency");
  for (const RankEstimate& estimate : estimates)
    text += fmt::format(
        "  {:>6} {:>10.0f} {:>10.0f} {:>9.2f} {:>9} {:>10} {:>9} {:>11} {:>8.4g} "
        "{:>9.0f}%\n",
        estimate.ranks, estimate.particles, estimate.ghosts, estimate.imbalance,
        readable(estimate.memory, "B"), readable(estimate.bytes, "B"),
        readable(estimate.step_time, "s"), duration_text(estimate.run_time), estimate.speed_up,
        100.0 * estimate.efficiency);
  text +=
      "  Particles, ghosts, memory for them and what is sent in a step are those of the rank that "
      "has most, "
      "at "
      "the start.\n  While it lays the case out, and rank 0 while it writes a frame, a rank needs "
      "the "
      "memory of one.\n";
  if (refinement != 1.0)
    text += fmt::format(
        "  A layout of {} particles was divided; its parts were scaled as volumes and its ghosts "
        "as surfaces, to {:.3g} times as many particles.\n",
        laid_out, refinement);
  const bool ends = paying_ranks() == estimates.back().ranks;
  text += ends ? fmt::format("  Up to {} ranks pay: the efficiency is above 50%.\n", paying_ranks())
               : fmt::format("  More than {} {} not pay: the efficiency falls below 50%.\n",
                             paying_ranks(), paying_ranks() == 1 ? "rank does" : "ranks do");
  return text;
}

nlohmann::ordered_json RankPlan::json() const {
  nlohmann::ordered_json json = {
      {"threads", threads},
      {"latency", network.latency},
      {"bandwidth", network.bandwidth},
      {"laid_out_particles", laid_out},
      {"refinement", refinement},
      {"waits_per_step",
       {{"neighbours", waits.neighbours}, {"sums", waits.sums}, {"lists", waits.lists}}},
      {"paying_ranks", paying_ranks()},
      {"estimates", nlohmann::ordered_json::array()}};
  for (const RankEstimate& estimate : estimates) json["estimates"].push_back(json_of(estimate));
  return json;
}

void refuse_unplanned([[maybe_unused]] const Case& description, const std::string& file,
                      int ranks) {
  const std::string asked = fmt::format("{}: --ranks {}", file, ranks);
  refuse_without_ranks(asked);
  if constexpr (ranks::exist)
    refuse_undistributed(description, asked, "Leave the option out: one rank computes the case.");
}

RankPlan rank_plan(const CostedCase& costed, int ranks, int threads, const Network& network) {
  const RunCost cost = run_cost(costed.numbers, costed.pace);
  const auto particles = static_cast<double>(costed.numbers.particles_initial);
  const auto layout = lay_out(costed.description, particles);
  RankPlan plan;
  plan.network = network;
  plan.threads = threads;
  plan.laid_out = layout->particles();
  if (particles > most_laid_out) plan.refinement = particles / double(plan.laid_out);
  const OneRank one{costed.description.dimension, cost.seconds / cost.steps, cost.steps,
                    cost.particle_memory,         costed.pace.bond_share,    plan.refinement};
  for (const int count : numbers_up_to(ranks)) {
    const RankLoads loads = layout->rank_loads(count);
    plan.waits = loads.waits;
    plan.estimates.push_back(estimate_ranks(loads, one, network));
  }
  return plan;
}

}  // namespace kerf
