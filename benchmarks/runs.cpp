// SPDX-License-Identifier: Apache-2.0
// Whole steps of whole cases: run/CASE and run/water/3D/particles. Every iteration takes the same
// steps from the same state, so that results of different machines are of the same work.
#include <fmt/format.h>
#include <malloc.h>

#include <filesystem>
#include <functional>

#include "engine/device.hpp"
#include "input/read.hpp"
#include "loads.hpp"
#include "measure.hpp"

namespace kerf {
namespace {

constexpr int timed_steps = 20;
// Before them: blocks are in motion at once, a jet has to arrive.
constexpr int steps_of_blocks = 20, steps_of_cases = 1000;

// Of the heap, bytes in use.
double held_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

void take_steps(Simulation& simulation, int steps, double& particle_steps) {
  for (int step = 0; step < steps && !simulation.finished(); ++step) {
    simulation.advance();
    particle_steps += static_cast<double>(simulation.particles());
  }
}

void measure_run(benchmark::State& state, const Case& description, int warm_up_steps) {
  const double free_of_it = held_bytes();
  const auto simulation = make_simulation(description);
  double particle_steps = 0.0;
  take_steps(*simulation, warm_up_steps, particle_steps);
  const double held = held_bytes() - free_of_it;
  state.counters["held_bytes_per_particle"] = held / static_cast<double>(simulation->particles());
  Archive start;
  simulation->save(start);
  particle_steps = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    simulation->restore(start);
    state.ResumeTiming();
    take_steps(*simulation, timed_steps, particle_steps);
  }
  if (particle_steps == 0.0) fail(state, "the case is over before it is timed");
  report(state, *simulation, particle_steps);
}

void add(const std::string& name, int warm_up_steps, const std::function<Case()>& make_case) {
  benchmark::RegisterBenchmark(
      name.c_str(),
      [=](benchmark::State& state) {
        guarded(state, [&](benchmark::State& s) { measure_run(s, make_case(), warm_up_steps); });
      })
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void add_run_benchmark(const std::string& case_file) {
  add("run/" + std::filesystem::path(case_file).stem().string(), steps_of_cases,
      [case_file] { return read_case(case_file); });
}

void add_block_run_benchmarks() {
  for (const Load load : {Load::water, Load::solid})
    for (const std::size_t particles : numbers_of_particles)
      add(fmt::format("run/{}/3D/{}", load_name(load), particles), steps_of_blocks,
          [load, particles] { return load_case(load, 3, particles); });
}

}  // namespace kerf
