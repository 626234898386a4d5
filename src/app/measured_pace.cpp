// SPDX-License-Identifier: Apache-2.0
#include "app/measured_pace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <optional>
#include <thread>

#include "analysis/cut.hpp"
#include "core/error.hpp"
#include "engine/device.hpp"
#include "model/case.hpp"
#include "parallel/threads.hpp"

namespace kerf {

namespace {

constexpr double most_pilot_particles = 1e4;
constexpr double most_graded_pilot = 3e3;    // of graded bodies, which take long to set up
constexpr double usual_pilot = 1000.0;       // particles that a long run is not coarsened below
constexpr double least_pilot = 200.0;        // particles that tell the time of one
constexpr double least_pilot_steps = 100.0;  // steps that tell the same
constexpr double setup_time = 1e-4;          // s of the processor for a particle of a pilot
constexpr double least_for_steps = 0.2;      // s of the processor for the steps of a pilot
constexpr double busy = 1.3;                 // time of day over that of the processor

double most_particles(const Case& description) {
  const bool is_graded = std::any_of(description.bodies.begin(), description.bodies.end(),
                                     [](const Body& body) { return body.grading.levels > 0; });
  return is_graded ? most_graded_pilot : most_pilot_particles;
}

// Returns the factor of the spacing at which a run makes as many steps of particles as the pilot
// may take: they are as the power -(D + 1) of the spacing. Few particles tell nothing, so that the
// pilot of a long run covers a part of its time instead.
double coarsening(const Case& description, const DerivedNumbers& numbers) {
  const double particles = numbers.particles_mean;
  const double steps = PilotLimits{}.processor / typical_pace(description, 1).particle_step;
  const double by_work =
      std::pow(particles * numbers.steps / steps, 1.0 / (description.dimension + 1));
  const auto by_size = [&](double wanted) {
    return std::pow(static_cast<double>(numbers.particles_initial) / wanted,
                    1.0 / description.dimension);
  };
  return std::max(
      {1.0, std::min(by_work, by_size(usual_pilot)), by_size(most_particles(description))});
}

// Returns the time that a processor has spent on this thread, s. Unlike the time of day it does not
// depend on what else runs meanwhile.
double thread_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double wall_seconds(WallClock::time_point from, WallClock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

// Returns how many programs wait for each core of this machine, in the mean over a minute.
double load_of_cores() {
  double load = 0.0;
  if (getloadavg(&load, 1) != 1) return 1.0;
  return load / std::max(1u, std::thread::hardware_concurrency());
}

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
  const double start = thread_time();
  for (int row = 0; row < rows; ++row)
    cut.observe(simulation.frame_of_cut(), simulation.balance().impulse_water);
  return (thread_time() - start) / (rows * static_cast<double>(simulation.particles()));
}

PilotResult make_pilot_run(const Case& description, const PilotLimits& limits) {
  PilotResult run;
  const auto simulation = make_simulation(description);
  run.particles = static_cast<double>(simulation->particles());
  CutMonitor cut(description, simulation->frame());
  if (!simulation->finished())
    simulation->advance();  // the first step also builds the neighbour lists
  const double start = thread_time(), first_time = simulation->time();
  const auto wall_start = WallClock::now();
  auto now = wall_start;
  while (run.seconds < limits.processor && now < limits.until && !simulation->finished()) {
    simulation->advance();
    run.particle_steps += static_cast<double>(simulation->particles());
    run.steps += 1.0;
    run.seconds = thread_time() - start;
    now = WallClock::now();
  }
  run.wall_seconds = wall_seconds(wall_start, now);
  const DerivedNumbers numbers = derive(description);
  const double simulated = simulation->time() - first_time;
  run.expected_steps = simulated / numbers.time_step;
  run.share = std::min(1.0, simulated / numbers.likely_end);
  run.bond_share = bond_share(*simulation);
  run.particle_row = particle_row(*simulation, cut);
  return run;
}

// Returns how the pace was found, in a clause.
std::string source_of(const PilotResult& run) {
  const double percent = 100.0 * run.share;
  std::string source =
      fmt::format("by a pilot run of {:.0f} particles over {}% of the time", run.particles,
                  percent < 1.0 ? fmt::format("{:.1g}", percent) : fmt::format("{:.0f}", percent));
  const double slower = run.wall_seconds / run.seconds;
  if (slower > busy)
    source += fmt::format(
        "; the cores are busy, beside what they do now the run takes {:.1f} times as long", slower);
  return source;
}

Pace pace_by(const PilotResult& run, const Case& description, int threads) {
  Pace pace = typical_pace(description, threads);
  const double on_threads = pace.particle_step / typical_pace(description, 1).particle_step;
  pace.particle_step = on_threads * run.seconds / run.particle_steps;
  pace.particle_row = on_threads * run.particle_row;
  pace.step_factor = step_factor(run);
  pace.bond_share = run.bond_share;
  pace.source = source_of(run);
  return pace;
}

// Returns what a pilot run sees; nothing where this build has no engine for the case, or the coarse
// run breaks down.
std::optional<PilotResult> run_pilot(Case pilot, const PilotLimits& limits) {
  try {
    for (Body& body : pilot.bodies) body.body_fitted = false;  // as fast, and laid out at once
    return make_pilot_run(pilot, limits);
  } catch (const UserError&) {
    return {};
  }
}

Pace typical_since(const Case& description, int threads, const std::string& reason) {
  Pace pace = typical_pace(description, threads);
  pace.source += ", because " + reason;
  return pace;
}

Pace pace_on_one_thread(const Case& description, const DerivedNumbers& numbers, int threads,
                        const PilotLimits& limits) {
  // A lattice may happen to have particles on a symmetry plane; then another one is tried.
  for (const double stretch : {1.0, 1.1, 1.21, 1.33}) {
    const Case pilot = pilot_case(description, numbers, stretch);
    const auto particles = static_cast<double>(derive(pilot).particles_initial);
    if (particles > 4.0 * most_pilot_particles) continue;
    const double needed = limits.slower * (setup_time * particles + least_for_steps);
    if (wall_seconds(WallClock::now(), limits.until) < needed)
      return typical_since(description, threads, "the machine is too busy for a pilot run");
    const auto run = run_pilot(pilot, limits);
    if (!run) continue;
    if (is_telling(*run, static_cast<double>(numbers.particles_initial)))
      return pace_by(*run, description, threads);
    return typical_since(
        description, threads,
        fmt::format("a pilot run of {:.0f} particles and {:.0f} steps does not tell that of the "
                    "case (least: {:.0f} and {:.0f})",
                    run->particles, run->steps, least_pilot, least_pilot_steps));
  }
  return typical_pace(description, threads);
}

}  // namespace

PilotLimits limits_of_answer(WallClock::time_point begun) {
  constexpr double answered = 4.5, advice = 0.6;  // s: of the day, and of the processor
  const auto now = WallClock::now();
  const double before = wall_seconds(begun, now);
  PilotLimits limits;
  limits.slower = std::max(
      {1.0, before * CLOCKS_PER_SEC / std::max(1.0, double(std::clock())), load_of_cores()});
  const std::chrono::duration<double> left(answered - 2.0 * before - advice * limits.slower);
  limits.until = now + std::chrono::duration_cast<WallClock::duration>(left);
  return limits;
}

bool is_telling(const PilotResult& run, double particles) {
  return run.steps >= least_pilot_steps && run.particles >= std::min(least_pilot, particles);
}

double step_factor(const PilotResult& run) {
  return std::pow(run.steps / run.expected_steps, 0.5 * (1.0 + run.share));
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

Pace measured_pace(const Case& description, const DerivedNumbers& numbers, int threads,
                   const PilotLimits& limits) {
  set_threads(1);
  const Pace pace = pace_on_one_thread(description, numbers, threads, limits);
  set_threads(threads);
  return pace;
}

}  // namespace kerf
