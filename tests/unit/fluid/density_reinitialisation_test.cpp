// SPDX-License-Identifier: Apache-2.0
// The density of moving water returns to that of its kernel sum; water at rest, at a free surface
// or in its nozzle is excluded.
#include "fluid/density_reinitialisation.hpp"

#include <gtest/gtest.h>

#include "core/precision.hpp"
#include "parallel/loops.hpp"

namespace kerf::test::density_reinitialisation_test {
namespace {

constexpr double lattice_kernel_sum = 1.01, dt = 1e-3;

struct Shock {
  EquationOfState law = EquationOfState::tait;
  double squeeze = 0.0;  // 1/s, - div v
};

// Returns the compression, after one step, of a particle whose density is 1% above that of its
// kernel sum.
double after_a_step(Phase phase, double kernel_sum, double max_relative_velocity,
                    std::uint8_t flags = 0, const Shock& shock = {}) {
  Particles<2, Double> particles;
  std::vector<Medium<double>> media(1);
  media[0].phase = phase;
  media[0].density = 1000.0;
  media[0].equation_of_state = shock.law;
  to_device(media, particles.media);
  particles.resize(1);
  particles.source[0] = 0;
  particles.flags[0] = flags;
  particles.kernel_sum[0] = kernel_sum;
  particles.max_relative_velocity[0] = max_relative_velocity;
  particles.compression[0] = kernel_sum / lattice_kernel_sum - 1.0 + 0.01;
  particles.compression_rate[0] = shock.squeeze * (1.0 + particles.compression[0]);
  for_each_index(1, DensityReinitialisation<2, Double>{particles.view(), dt, lattice_kernel_sum});
  return particles.compression[0] - (kernel_sum / lattice_kernel_sum - 1.0);
}

TEST(DensityReinitialisation, HasTheRateOfTheRelativeVelocity) {
  const double max_relative_velocity = 25.0;
  EXPECT_NEAR(after_a_step(Phase::water, 1.02, max_relative_velocity),
              0.01 * (1.0 - DensityReinitialisation<2, Double>::rate * max_relative_velocity * dt),
              1e-12);
}

TEST(DensityReinitialisation, DoesNotOvershootTheKernelSum) {
  EXPECT_NEAR(after_a_step(Phase::water, 0.97, 1e6), 0.0, 1e-12);
}

// Relative velocity by compression alone does not count.
TEST(DensityReinitialisation, PausesInWaves) {
  const double rate = DensityReinitialisation<2, Double>::rate;
  for (const auto law : {EquationOfState::shock_hugoniot, EquationOfState::tait}) {
    EXPECT_NEAR(after_a_step(Phase::water, 1.02, 25.0, 0, {law, 5.0}),
                0.01 * (1.0 - rate * 15.0 * dt), 1e-12);
    EXPECT_NEAR(after_a_step(Phase::water, 1.02, 25.0, 0, {law, -5.0}),
                0.01 * (1.0 - rate * 15.0 * dt), 1e-12);
    EXPECT_NEAR(after_a_step(Phase::water, 1.02, 25.0, 0, {law, 13.0}), 0.01, 1e-12);
  }
}

TEST(DensityReinitialisation, ChangesFluidParticlesOnly) {
  EXPECT_NEAR(after_a_step(Phase::water, 1.02, 0.0), 0.01, 1e-12);
  EXPECT_NEAR(after_a_step(Phase::water, 0.8, 25.0), 0.01, 1e-12);
  EXPECT_NEAR(after_a_step(Phase::solid, 1.02, 25.0), 0.01, 1e-12);
  EXPECT_NEAR(after_a_step(Phase::water, 1.02, 25.0, flag::upstream), 0.01, 1e-12);
}

}  // namespace
}  // namespace kerf::test::density_reinitialisation_test
