// SPDX-License-Identifier: Apache-2.0
// Results have the same bits for any number of threads, after a restart at any step, and with or
// without output between steps.
#include <oneapi/tbb/task_arena.h>

#include <random>
#include <tuple>

#include "model/material_laws.hpp"
#include "parallel/threads.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

class SameAnswer : public testing::TestWithParam<std::tuple<int, PrecisionKind, Formulation>> {
 protected:
  ~SameAnswer() override { set_threads(0); }

  Case description() const {
    Case c =
        jet_on_block(std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam()));
    Probe point, plane;
    point.name = "point";
    point.position = {0.0, 0.006, 0.0};
    plane.name = "plane";
    plane.kind = Probe::Kind::plane;
    plane.position = {0.0, 0.004, 0.0};
    c.probes = {point, plane};
    if (c.formulation == Formulation::standard && c.precision == PrecisionKind::mixed) {
      c.materials[0].plasticity = PlasticLaw::von_mises;
      c.materials[0].laws->plastic.von_mises.yield_stress = 2e3;
      c.materials[0].friction = 0.3;
      if (std::get<0>(GetParam()) == 2) depend_on_rate(c.materials[0]);
    } else if (c.formulation == Formulation::standard) {
      c.materials[0].criterion = BondCriterion::grady_kipp;
      c.materials[0].laws->grady_kipp.weibull_k = 1e18;
      c.materials[0].laws->grady_kipp.weibull_m = 6.0;
      c.materials[0].laws->grady_kipp.flaw_depth = 1e-3;
      c.bodies[0].jitter = 0.2;
    }
    if (c.formulation == Formulation::standard && c.precision == PrecisionKind::double_precision) {
      c.materials[0].poisson_ratio = 0.49;
      c.bodies[0].grading = {1, 2e-3, box({-3e-3, 0.0, -3e-3}, {3e-3, 9e-3, 3e-3}), {}};
    }
    if (c.precision == PrecisionKind::double_precision) c.numerics = {WaterScheme::delta_sph, true};
    c.back_flow_removal = BackFlowRemoval{};
    return c;
  }
  static void depend_on_rate(Material& material) {
    material.plasticity = PlasticLaw::none;
    material.criterion = BondCriterion::crack_band;
    material.failure_strain = 0.02;
    material.fracture_energy = 0.5;
    material.laws->strength_rate = {0.1, 1.0};
  }
  int steps() const { return std::get<0>(GetParam()) == 2 ? 500 : 200; }

  // Sets the number of threads even if there are fewer cores.
  static std::unique_ptr<Simulation> run_on(int threads, const Case& description, int steps) {
    set_threads(threads);
    return tbb::task_arena(threads).execute([&] {
      auto simulation = make_simulation(description);
      take_steps(*simulation, steps);
      return simulation;
    });
  }
};

TEST_P(SameAnswer, AnyNumberOfThreads) {
  const auto one = run_on(1, description(), steps());
  // The case has inflow, outflow and fracture.
  EXPECT_GT(one->balance().mass_in, 0.0);
  // The neighbours of a broken bond may store more energy than the bond releases.
  EXPECT_NE(one->balance().dissipated_fracture, 0.0);
  if (std::get<0>(GetParam()) == 2) {
    EXPECT_GT(one->balance().mass_out + one->balance().mass_erased, 0.0);
  }
  for (int threads : {2, 3}) expect_same_run(*one, *run_on(threads, description(), steps()));
}

TEST_P(SameAnswer, AfterARestart) {
  const Case c = description();
  std::mt19937 engine(static_cast<unsigned>(steps()));
  const int at = 1 + static_cast<int>(engine() % static_cast<unsigned>(steps() - 1));
  const auto whole = make_simulation(c);
  take_steps(*whole, at);
  Archive archive = saved(*whole);
  take_steps(*whole, steps() - at);
  const auto resumed = make_simulation(c);
  resumed->restore(archive);
  EXPECT_EQ(resumed->step(), static_cast<std::uint64_t>(at));
  take_steps(*resumed, steps() - at);
  EXPECT_EQ(resumed->step(), whole->step());
  expect_same_run(*whole, *resumed);
}

// A resumed run writes the same checkpoint again, and restarts after every few steps change
// nothing.
TEST_P(SameAnswer, AfterManyRestarts) {
  const Case c = description();
  const auto whole = make_simulation(c);
  take_steps(*whole, steps() / 2);
  auto current = make_simulation(c);
  for (int n = 0; n < steps() / 2; n += 7) {
    take_steps(*current, std::min(7, steps() / 2 - n));
    const Archive archive = saved(*current);
    current = make_simulation(c);
    current->restore(archive);
    expect_same_state(archive, saved(*current));
  }
  expect_same_run(*whole, *current);
}

TEST_P(SameAnswer, OutputDoesNotChangeTheState) {
  const Case c = description();
  const auto undisturbed = make_simulation(c), looked_at = make_simulation(c);
  take_steps(*undisturbed, steps());
  for (int n = 0; n < steps(); ++n) {
    looked_at->advance();
    if (n % 5 == 0) looked_at->frame();
    if (n % 7 == 0) looked_at->balance();
    if (n % 11 == 0) looked_at->probe_values();
    if (n % 13 == 0) saved(*looked_at);
  }
  expect_same_run(*undisturbed, *looked_at);
  // Output does not depend on earlier output.
  const auto probes = undisturbed->probe_values();
  expect_same_ledger(undisturbed->balance(), looked_at->balance());
  expect_same_frame(undisturbed->frame(), looked_at->frame());
  EXPECT_EQ(probes, looked_at->probe_values());
}

// Water beside a smooth wall is completed after the sums over pairs, in output as in a step.
TEST(Output, ChangesNoNumberOfACheckpoint) {
  for (const int dimension : {2, 3}) {
    const auto simulation = make_simulation(standard_jet_on_block(dimension, PrecisionKind::mixed));
    take_steps(*simulation, dimension == 2 ? 500 : 200);
    const Archive before = saved(*simulation);
    simulation->balance();
    simulation->frame();
    expect_same_state(before, saved(*simulation));
  }
}

// The frame of the restored state equals that of the saved one.
TEST_P(SameAnswer, RestoredStateHasTheSameFrame) {
  const Case c = description();
  const auto first = make_simulation(c);
  take_steps(*first, steps() / 2);
  const auto second = make_simulation(c);
  second->restore(saved(*first));
  expect_same_run(*first, *second);
  EXPECT_EQ(first->probe_values(), second->probe_values());
  EXPECT_EQ(first->pair_interactions(), second->pair_interactions());
  EXPECT_EQ(first->last_step().dt, second->last_step().dt);
  EXPECT_EQ(first->last_step().limit, second->last_step().limit);
}

std::string name_of(const testing::TestParamInfo<SameAnswer::ParamType>& info) {
  return std::string(std::get<0>(info.param) == 2 ? "2D" : "3D") +
         (std::get<1>(info.param) == PrecisionKind::mixed ? "Mixed" : "Double") +
         (std::get<2>(info.param) == Formulation::standard ? "Standard" : "");
}
INSTANTIATE_TEST_SUITE_P(
    All, SameAnswer,
    testing::Combine(testing::Values(2, 3),
                     testing::Values(PrecisionKind::mixed, PrecisionKind::double_precision),
                     testing::Values(Formulation::shinohara2004, Formulation::standard)),
    name_of);

}  // namespace
}  // namespace kerf::test
