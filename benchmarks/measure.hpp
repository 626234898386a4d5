// SPDX-License-Identifier: Apache-2.0
// What all benchmarks report, and how they fail: Google Benchmark itself ends with 0 whatever
// happened in them.
#pragma once

#include <benchmark/benchmark.h>

#include <exception>
#include <string>

#include "simulation/simulation.hpp"

namespace kerf {

// Whether a benchmark has failed so far.
inline bool& any_failed() {
  static bool failed = false;
  return failed;
}

inline void fail(benchmark::State& state, const std::string& why) {
  any_failed() = true;
  state.SkipWithError(why.c_str());
}

// Runs `measure(state)`; what it throws is the failure of this benchmark alone.
template <class Measure>
void guarded(benchmark::State& state, const Measure& measure) {
  try {
    measure(state);
  } catch (const std::exception& error) {
    fail(state, error.what());
  }
}

// One item is one particle that took one step, or one stage of it.
inline void report(benchmark::State& state, const Simulation& simulation, double particle_steps) {
  state.SetItemsProcessed(static_cast<std::int64_t>(particle_steps));
  state.counters["particles"] = static_cast<double>(simulation.particles());
  state.counters["neighbours_per_particle"] = simulation.neighbours_per_particle();
  state.counters["bytes_per_particle"] = simulation.bytes_per_particle();
}

// Each of these registers its benchmarks.
void add_stage_benchmarks();
void add_run_benchmark(const std::string& case_file);
void add_block_run_benchmarks();

}  // namespace kerf
