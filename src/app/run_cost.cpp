// SPDX-License-Identifier: Apache-2.0
#include "app/run_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/observation_times.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"

namespace kerf {

namespace {

constexpr double least_across_pilot = 2.0;  // particles across a jet
constexpr double typical_row = 0.5;         // of the time of a step, for a row of series.csv
constexpr double thread_efficiency = 0.95;  // docs/performance.md, of each thread after the first

// Returns the time of one step of one particle on one core, s: that of whole runs of the shipped
// cases, with their debris and contacts (docs/performance.md).
double typical_particle_step(const Case& description) {
  const bool plane = description.dimension == 2;
  if (description.formulation == Formulation::standard) return plane ? 0.58e-6 : 1.7e-6;
  return plane ? 3.3e-6 : 7.0e-6;
}

// Returns the number of rows of series.csv and of observations of the cut, which take as long.
double rows_of(const Case& description) {
  const double end = description.time.end;
  return end / description.output.series_interval + ObservationTimes(description).count(end);
}

double on_threads(double seconds, int threads) {
  return seconds / (1.0 + thread_efficiency * (threads - 1));
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

std::string run_time_text(const RunCost& cost, const Pace& pace) {
  return fmt::format("about {} on {} {}, {}", duration_text(cost.seconds), pace.threads,
                     pace.threads == 1 ? "thread" : "threads", pace.source);
}

RunCost run_cost(const DerivedNumbers& numbers, const Pace& pace) {
  RunCost cost;
  cost.particles = numbers.particles_mean;
  cost.steps = pace.step_factor * numbers.steps;
  cost.memory = numbers.memory;
  cost.particle_memory = numbers.particle_memory;
  const double rows = pace.rows * numbers.likely_share;
  cost.seconds = cost.particles * (pace.particle_step * cost.steps + pace.particle_row * rows);
  return cost;
}

}  // namespace kerf
