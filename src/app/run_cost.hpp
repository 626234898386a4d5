// SPDX-License-Identifier: Apache-2.0
// What a run will cost: particles, steps, memory and time, estimated before anything is laid out.
//
// The time is particles x (steps x pace + rows of series.csv x their pace): the time of one step or
// row for one particle. A pilot run measures both (app/measured_pace.hpp).
#pragma once

#include <string>

#include "analysis/derived.hpp"

namespace kerf {

struct Case;

struct Pace {
  double particle_step = 0.0;  // s, on all threads of the run
  double particle_row = 0.0;   // s, the same for a row of series.csv
  double rows = 0.0;           // until the end of the case
  double step_factor = 1.0;    // steps that are made over those of the estimate
  std::string source;          // how it was found
  // Of the time of cases with solids, what bonds and their fracture take (docs/performance.md).
  double bond_share = 0.5;
  int threads = 1;  // of the run
};

struct RunCost {
  double particles = 0.0;  // mean over the run
  double steps = 0.0;
  double memory = 0.0;           // bytes, of the process at its peak
  double particle_memory = 0.0;  // bytes, of that the data of the engine
  double seconds = 0.0;          // of the run
};

// Returns the pace of a typical case of the same dimension and formulation on one core.
Pace typical_pace(const Case& description, int threads);

// Returns the case at a spacing that is `factor` times as wide; jets stay two particles wide.
Case with_coarser_particles(const Case& description, double factor);

RunCost run_cost(const DerivedNumbers& numbers, const Pace& pace);

// Returns the run time with the number of threads for which it holds and how it was found.
std::string run_time_text(const RunCost& cost, const Pace& pace);

}  // namespace kerf
