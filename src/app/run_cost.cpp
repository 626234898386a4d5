// SPDX-License-Identifier: Apache-2.0
#include "app/run_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "analysis/cut.hpp"
#include "core/error.hpp"
#include "engine/device.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "parallel/threads.hpp"

namespace kerf {

namespace {

constexpr double most_pilot_particles = 1e4;
constexpr double most_graded_pilot = 3e3;   // of graded bodies, which take long to set up
constexpr double longest_pilot = 2.8;       // s
constexpr double least_across_pilot = 2.0;  // particles across a jet
constexpr double typical_row = 0.5;         // of the time of a step, for a row of series.csv
constexpr double thread_efficiency = 0.95;  // docs/performance.md, of each thread after the first

// Returns the time of one step of one particle on one core, s (docs/performance.md).
double typical_particle_step(const Case& description) {
  const bool plane = description.dimension == 2;
  if (description.formulation == Formulation::standard) return plane ? 0.35e-6 : 0.7e-6;
  return plane ? 1.9e-6 : 4.0e-6;
}

double rows_of(const Case& description) {
  return description.time.end / description.output.series_interval;
}

double on_threads(double seconds, int threads) {
  return seconds / (1.0 + thread_efficiency * (threads - 1));
}

double most_particles(const Case& description) {
  const bool is_graded = std::any_of(description.bodies.begin(), description.bodies.end(),
                                     [](const Body& body) { return body.grading.levels > 0; });
  return is_graded ? most_graded_pilot : most_pilot_particles;
}

// Returns the factor of the spacing at which a run makes as many steps of particles as the pilot
// may take: they are as the power -(D + 1) of the spacing.
double coarsening(const Case& description, const DerivedNumbers& numbers) {
  const double particles = numbers.particles_mean;
  const double steps = longest_pilot / typical_particle_step(description);
  const double by_work =
      std::pow(particles * numbers.steps / steps, 1.0 / (description.dimension + 1));
  const double by_size =
      std::pow(particles / most_particles(description), 1.0 / description.dimension);
  return std::max({1.0, by_work, by_size});
}

// Returns the time that processors have spent on this program, s. Unlike the time of day it does
// not depend on other programs that run meanwhile.
double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct PilotRun {
  double seconds = 0.0, particle_steps = 0.0, steps = 0.0, simulated = 0.0, bond_share = 0.0;
  double particle_row = 0.0;
};

// Returns the share of bonds and fracture in the time of all stages of a run.
double bond_share(const Simulation& simulation) {
  double bonds = 0.0, all = 0.0;
  for (const StageTime& stage : simulation.stage_times()) {
    all += stage.seconds;
    if (stage.name == "solid" || stage.name == "fracture") bonds += stage.seconds;
  }
  return all > 0.0 ? bonds / all : 0.0;
}

// Returns the time that a row of series.csv takes for each particle, s: the balance needs the
// forces at the end of a step, and the verdict the pieces.
double particle_row(const Simulation& simulation, CutMonitor& cut) {
  constexpr int rows = 3;
  const double start = processor_time();
  for (int row = 0; row < rows; ++row)
    cut.observe(simulation.frame_of_cut(), simulation.balance().impulse_water);
  return (processor_time() - start) / (rows * static_cast<double>(simulation.particles()));
}

PilotRun make_pilot_run(const Case& description) {
  PilotRun run;
  const auto simulation = make_simulation(description);
  CutMonitor cut(description, simulation->frame());
  if (!simulation->finished())
    simulation->advance();  // the first step also builds the neighbour lists
  const double start = processor_time();
  const double first_time = simulation->time();
  while (run.seconds < longest_pilot && !simulation->finished()) {
    simulation->advance();
    run.particle_steps += static_cast<double>(simulation->particles());
    run.steps += 1.0;
    run.seconds = processor_time() - start;
  }
  run.simulated = simulation->time() - first_time;
  run.bond_share = bond_share(*simulation);
  run.particle_row = particle_row(*simulation, cut);
  return run;
}

// Returns the pace of a pilot run on one core; nothing where this build has no engine for the case,
// or the coarse run breaks down.
std::optional<Pace> pace_of_pilot(const Case& description, const DerivedNumbers& numbers,
                                  double stretch) {
  try {
    Case pilot = pilot_case(description, numbers, stretch);
    for (Body& body : pilot.bodies) body.body_fitted = false;  // as fast, and laid out at once
    const DerivedNumbers coarse = derive(pilot);
    if (static_cast<double>(coarse.particles_initial) > 4.0 * most_pilot_particles) return {};
    set_threads(1);
    const PilotRun run = make_pilot_run(pilot);
    if (run.particle_steps == 0.0) return {};
    return Pace{run.seconds / run.particle_steps,
                run.particle_row,
                rows_of(description),
                run.steps * coarse.time_step / run.simulated,
                fmt::format("by a pilot run of {} particles over {:.0f}% of the time",
                            coarse.particles_initial, 100.0 * run.simulated / description.time.end),
                run.bond_share};
  } catch (const UserError&) {
    return {};
  }
}

}  // namespace

Pace typical_pace(const Case& description, int threads) {
  const double step = on_threads(typical_particle_step(description), threads);
  Pace pace{step, typical_row * step, rows_of(description), 1.0, "by the typical speed of a core"};
  pace.threads = threads;
  return pace;
}

Case with_coarser_particles(const Case& description, double factor) {
  Case pilot = description;
  for (Body& body : pilot.bodies) body.spacing *= factor;
  for (Jet& jet : pilot.jets) {
    const double across = jet.width / jet.spacing;
    jet.spacing *= std::clamp(across / least_across_pilot, 1.0, factor);
  }
  return pilot;
}

Case pilot_case(const Case& description, const DerivedNumbers& numbers, double stretch) {
  double factor = stretch * coarsening(description, numbers);
  Case pilot = with_coarser_particles(description, factor);
  // The finest level of a graded body is as wide as before, so that coarser particles leave more of
  // them than their size says.
  for (int trial = 0; trial < 4; ++trial) {
    const double excess =
        static_cast<double>(derive(pilot).particles_initial) / (1.1 * most_particles(description));
    if (excess <= 1.0) break;
    factor *= std::pow(excess, 1.0 / description.dimension);
    pilot = with_coarser_particles(description, factor);
  }
  return pilot;
}

Pace measured_pace(const Case& description, const DerivedNumbers& numbers, int threads) {
  // A lattice may happen to have particles on a symmetry plane; then another one is tried.
  for (const double stretch : {1.0, 1.1, 1.21, 1.33})
    if (const auto pace = pace_of_pilot(description, numbers, stretch)) {
      Pace result = *pace;
      result.particle_step = on_threads(pace->particle_step, threads);
      result.particle_row = on_threads(pace->particle_row, threads);
      result.threads = threads;
      set_threads(threads);
      return result;
    }
  set_threads(threads);
  return typical_pace(description, threads);
}

std::string run_time_text(const RunCost& cost, const Pace& pace) {
  return fmt::format("about {} on {} {}, {}", duration_text(cost.seconds), pace.threads,
                     pace.threads == 1 ? "thread" : "threads", pace.source);
}

RunCost run_cost(const DerivedNumbers& numbers, const Pace& pace) {
  RunCost cost;
  cost.particles = numbers.particles_mean;
  cost.steps = pace.step_factor * numbers.steps;
  cost.memory = numbers.memory;
  const double rows = pace.rows * numbers.likely_share;
  cost.seconds = cost.particles * (pace.particle_step * cost.steps + pace.particle_row * rows);
  return cost;
}

}  // namespace kerf
