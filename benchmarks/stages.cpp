// SPDX-License-Identifier: Apache-2.0
// The stages of a step, each by itself: STAGE/LOAD/2D or 3D/particles.
#include <fmt/format.h>

#include <compare>
#include <memory>
#include <string>

#include "loads.hpp"
#include "measure.hpp"
#include "staged_run.hpp"

namespace kerf {
namespace {

using Call = void (StagedRun::*)();

struct Stage {
  const char* name;
  Load load;
  Call call;
  Call prepare = nullptr;               // before each call, not timed
  double Balance::*evidence = nullptr;  // what is not zero where the stage had work
};

constexpr Stage stages[] = {
    {"neighbours", Load::water, &StagedRun::find_neighbours},
    {"reorder_sorted", Load::water, &StagedRun::reorder},
    {"reorder_scattered", Load::water, &StagedRun::reorder, &StagedRun::scatter},
    {"fluid", Load::water, &StagedRun::compute_pair_forces},
    {"integrate", Load::water, &StagedRun::integrate},
    {"neighbours", Load::solid, &StagedRun::find_neighbours},
    {"bonds", Load::solid, &StagedRun::sum_over_bonds},
    {"fracture_look", Load::solid, &StagedRun::break_bonds},
    {"fracture_break", Load::solid, &StagedRun::break_bonds, &StagedRun::pull_apart,
     &Balance::dissipated_fracture},
    {"integrate", Load::solid, &StagedRun::integrate},
    {"contact", Load::slabs, &StagedRun::compute_pair_forces, nullptr, &Balance::rigid_potential},
    {"contact", Load::soaked, &StagedRun::compute_pair_forces},
};

struct Size {
  Load load;
  int dimension;
  std::size_t particles;
  auto operator<=>(const Size&) const = default;
};

// The run of the last size asked for: making one takes longer than most stages.
StagedRun& run_of(const Size& size) {
  static std::unique_ptr<StagedRun> run;
  static Size made{};
  if (run && made == size) return *run;
  run.reset();
  run = make_staged_run(load_case(size.load, size.dimension, size.particles));
  made = size;
  return *run;
}

void measure_stage(benchmark::State& state, const Stage& stage, const Size& size) {
  StagedRun& run = run_of(size);
  double particle_steps = 0.0;
  for (auto _ : state) {
    if (stage.prepare) {
      state.PauseTiming();
      (run.*stage.prepare)();
      state.ResumeTiming();
    }
    (run.*stage.call)();
    particle_steps += static_cast<double>(run.simulation().particles());
  }
  if (stage.evidence && run.simulation().balance().*stage.evidence == 0.0)
    fail(state, "the stage found nothing to do");
  run.settle();
  report(state, run.simulation(), particle_steps);
}

void add_stages_on(const Size& size) {
  for (const Stage& stage : stages) {
    if (stage.load != size.load) continue;
    const std::string name = fmt::format("{}/{}/{}D/{}", stage.name, load_name(size.load),
                                         size.dimension, size.particles);
    benchmark::RegisterBenchmark(
        name.c_str(),
        [&stage, size](benchmark::State& state) {
          guarded(state, [&](benchmark::State& s) { measure_stage(s, stage, size); });
        })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

void add_stage_benchmarks() {
  for (const Load load : {Load::water, Load::solid, Load::slabs, Load::soaked})
    for (const int dimension : {2, 3})
      for (const std::size_t particles : numbers_of_particles)
        add_stages_on({load, dimension, particles});
}

}  // namespace kerf
