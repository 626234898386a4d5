// SPDX-License-Identifier: Apache-2.0
// The engine for GPUs against that of the program, on the same cases. The emulated engine runs the
// code path of a GPU (packed loops, lists in passes) on threads of this machine.
#include "engine/device.hpp"
#include "model/material_laws.hpp"
#include "support/farthest.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

struct Run {
  int dimension;
  Formulation formulation;
};

class GpuEngineTest : public testing::TestWithParam<Run> {
 protected:
  void SetUp() override { setenv("KERF_GPU_ENGINE", KERF_EMULATED_ENGINE, 1); }
  void TearDown() override { set_device(Device::cpu); }

  static Case description() {
    return jet_on_block(GetParam().dimension, PrecisionKind::mixed, GetParam().formulation);
  }
  static std::unique_ptr<Simulation> make_on(Device device, const Case& c) {
    set_device(device);
    return make_simulation(c);
  }
  // Different orders of summation give different rounding errors: after 60 steps, in which the jet
  // hits the block, those of single precision (6e-8) have grown with the steps and with the
  // stiffness of the contact.
  static void expect_same_within_rounding(const Case& c) {
    const auto processor = make_on(Device::cpu, c), gpu = make_on(Device::gpu, c);
    take_steps(*processor, 60);
    take_steps(*gpu, 60);
    EXPECT_GT(processor->balance().mass_in, 0.0);
    const Frame a = processor->frame(), b = gpu->frame();
    ASSERT_EQ(a.id.size(), b.id.size());
    const double distance = farthest(
        a, b, [](const Frame& f) -> auto& { return f.position; });
    const double speed = farthest(
        a, b, [](const Frame& f) -> auto& { return f.velocity; });
    EXPECT_GT(speed, 0.0) << "the same bits: is it the same engine?";
    EXPECT_LT(distance, 1e-5 * c.jets[0].spacing);
    EXPECT_LT(speed, 1e-5 * c.jets[0].speed);
    const Balance x = processor->balance(), y = gpu->balance();
    EXPECT_NEAR(y.kinetic, x.kinetic, 1e-6 * x.kinetic);
    EXPECT_NEAR(y.energy_total(), x.energy_total(), 1e-6 * std::abs(x.energy_total()));
    EXPECT_DOUBLE_EQ(y.mass_in, x.mass_in);
  }
};

TEST_P(GpuEngineTest, SameWithinRounding) {
  expect_same_within_rounding(description());
}

// Solids without shared lists of bonds, and with several spacings; water with shocks.
TEST_P(GpuEngineTest, SameWithinRoundingInOtherMatter) {
  Case jittered = description(), graded = description(), shocks = description();
  jittered.bodies[0].jitter = 0.2;
  expect_same_within_rounding(jittered);
  if (GetParam().formulation != Formulation::standard) return;  // it has neither
  auto& grading = graded.bodies[0].grading;
  grading.levels = 2;
  grading.width = 3.0 * graded.bodies[0].spacing;
  grading.around = box({-2e-3, 7e-3, -2e-3}, {2e-3, 8e-3, 2e-3});
  EXPECT_LT(make_on(Device::cpu, graded)->particles(), make_on(Device::cpu, shocks)->particles());
  expect_same_within_rounding(graded);
  shocks.materials[1].equation_of_state = EquationOfState::shock_hugoniot;
  shocks.materials[1].laws->shock_hugoniot.slope = 2.0;
  expect_same_within_rounding(shocks);
}

TEST_P(GpuEngineTest, SameBitsAfterARestart) {
  set_device(Device::gpu);
  expect_same_bits_after_restart(description());
}

// A checkpoint is independent of the device.
TEST_P(GpuEngineTest, ContinuesARunOfTheCpu) {
  const Case c = description();
  const auto processor = make_on(Device::cpu, c);
  take_steps(*processor, 60);
  const Archive stop = saved(*processor);
  const auto gpu = make_on(Device::gpu, c);
  gpu->restore(stop);
  EXPECT_EQ(gpu->step(), 60u);
  expect_same_state(stop, saved(*gpu));
  const auto back = make_on(Device::cpu, c);
  back->restore(saved(*gpu));
  take_steps(*processor, 20);
  take_steps(*back, 20);
  expect_same_run(*processor, *back);
}

TEST_P(GpuEngineTest, HasFractureAndOutflow) {
  Case c = description();
  c.back_flow_removal = BackFlowRemoval{};
  const auto gpu = make_on(Device::gpu, c);
  take_steps(*gpu, c.dimension == 2 ? 500 : 200);
  const Balance balance = gpu->balance();
  EXPECT_NE(balance.dissipated_fracture, 0.0);
  if (c.dimension == 2) {
    EXPECT_GT(balance.mass_out + balance.mass_erased, 0.0);
  }
  EXPECT_LT(std::abs(balance.energy_drift()), 0.05);
}

TEST_P(GpuEngineTest, ReportsErrorsLikeTheCpuEngine) {
  Case c = description();
  c.precision = PrecisionKind::double_precision;  // not part of the library of the tests
  c.dimension = 3;
  set_device(Device::gpu);
  EXPECT_THROW(make_simulation(c), UserError);
}

INSTANTIATE_TEST_SUITE_P(Runs, GpuEngineTest,
                         testing::Values(Run{2, Formulation::standard},
                                         Run{3, Formulation::standard},
                                         Run{2, Formulation::shinohara2004}),
                         [](const auto& run) {
                           return formulation_name(run.param.formulation) +
                                  std::to_string(run.param.dimension) + "d";
                         });

}  // namespace
}  // namespace kerf::test
