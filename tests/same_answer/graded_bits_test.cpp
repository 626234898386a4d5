// SPDX-License-Identifier: Apache-2.0
// A graded, nearly incompressible solid has the same bits for any number of threads and after a
// restart: its pairs and bonds across the jump are summed by the SIMD kernels, with factors found
// anew for each neighbour list.
#include <oneapi/tbb/task_arena.h>

#include "parallel/threads.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

Case jet_on_graded_gel(int dimension) {
  Case c = jet_on_block(dimension, PrecisionKind::mixed, Formulation::standard);
  c.materials[0].poisson_ratio = 0.49;
  c.bodies[0].grading = {1, 2e-3, box({-3e-3, 0.0, -3e-3}, {3e-3, 9e-3, 3e-3}), {}};
  return c;
}

TEST(SameAnswerGraded, AnyNumberOfThreads) {
  for (const int dimension : {2, 3}) {
    const auto run_on = [&](int threads) {
      set_threads(threads);
      return tbb::task_arena(threads).execute([&] {
        auto simulation = make_simulation(jet_on_graded_gel(dimension));
        take_steps(*simulation, dimension == 2 ? 400 : 150);
        return simulation;
      });
    };
    const auto one = run_on(1);
    EXPECT_GT(one->balance().mass_in, 0.0);
    expect_same_run(*one, *run_on(3));
    set_threads(0);
  }
}

TEST(SameAnswerGraded, AfterARestart) {
  for (const int dimension : {2, 3}) expect_same_bits_after_restart(jet_on_graded_gel(dimension));
}

}  // namespace
}  // namespace kerf::test
