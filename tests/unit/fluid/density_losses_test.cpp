// SPDX-License-Identifier: Apache-2.0
// What densities lose of the work against pressure, against the stored energy in closed form.
#include "fluid/density_losses.hpp"

#include <gtest/gtest.h>

#include "core/precision.hpp"
#include "fluid/density_reinitialisation.hpp"
#include "parallel/loops.hpp"

namespace kerf::test::density_losses_test {
namespace {

// One particle of water, debris, or nearly incompressible solid of which a quarter of K acts by the
// density.
Particles<2, Double> one(Phase phase, bool detached) {
  Medium<double> medium;
  medium.phase = phase;
  medium.density = 1000.0;
  medium.cavitates = true;
  medium.tait.coefficient = 2e5;
  medium.total_bulk_modulus = 1.4e6;
  medium.excess_bulk_modulus = 3.5e5;
  medium.tensile_excess = 7e4;
  Particles<2, Double> particles;
  to_device(std::vector{medium}, particles.media);
  particles.resize(1);
  particles.source[0] = 0;
  particles.flags[0] = 0;
  particles.fractured[0] = detached ? 1 : 0;
  particles.undamaged[0] = 0;
  return particles;
}
// The energy that Tait's law stores, J/kg, by the part of its modulus that acts.
double stored(Particles<2, Double>& particles, double compression) {
  const auto view = particles.view();
  auto medium = view.medium(0);
  const bool bonded = medium.phase == Phase::solid && view.fractured[0] == 0;
  const bool opens = compression < 0.0 && !(bonded && view.undamaged[0] != 0);
  if (opens) return 0.0;
  const double part = !bonded             ? medium.total_bulk_modulus
                      : compression < 0.0 ? medium.tensile_excess
                                          : medium.excess_bulk_modulus;
  medium.cavitates = false;
  return part / medium.total_bulk_modulus * energy_at(medium, compression);
}

// The midpoint rule: an error of the third order in the change, 1e-3 here. Beside rho_0, where
// little is stored, that is 2e-4 of it.
TEST(DensityLosses, StoredChangeIsThatOfTheEnergy) {
  struct Kind {
    Phase phase;
    bool detached, undamaged;
  };
  for (const auto& [phase, detached, undamaged] :
       {Kind{Phase::water, false, false}, Kind{Phase::solid, false, false},
        Kind{Phase::solid, false, true}, Kind{Phase::solid, true, false}}) {
    auto particles = one(phase, detached);
    particles.undamaged[0] = undamaged;
    for (const double before : {-0.02, -1e-4, 0.0, 0.01, 0.1})
      for (const double change : {-1e-3, 1e-3}) {
        const double due = stored(particles, before + change) - stored(particles, before);
        EXPECT_NEAR(stored_change(particles.view(), 0, before, before + change), due,
                    3e-4 * std::abs(due) + 1e-12);
      }
  }
}

TEST(DensityLosses, ContinuityLosesWhatItDoesNotStore) {
  auto particles = one(Phase::water, false);
  particles.start_compression[0] = 0.01;
  particles.compression[0] = 0.0102;
  particles.pressure_power[0] = 50.0;  // W/kg
  for_each_index(1, ContinuityLoss<2, Double>{particles.view(), 0.1});
  EXPECT_NEAR(particles.continuity_loss[0],
              50.0 * 0.1 - (stored(particles, 0.0102) - stored(particles, 0.01)), 1e-6);
  EXPECT_EQ(particles.reinitialisation_loss[0], 0.0);
}

// All work on a solid whose bonds carry all of K is lost to the densities: those of the water gain
// it by their own continuity equation.
TEST(DensityLosses, MatterWithoutDensityStoresNothing) {
  auto particles = one(Phase::solid, false);
  auto medium = particles.view().medium(0);
  medium.excess_bulk_modulus = 0.0;
  to_device(std::vector{medium}, particles.media);
  particles.start_compression[0] = particles.compression[0] = 0.0;
  particles.pressure_power[0] = 50.0;
  for_each_index(1, ContinuityLoss<2, Double>{particles.view(), 0.1});
  EXPECT_NEAR(particles.continuity_loss[0], 5.0, 1e-14);
}

TEST(DensityLosses, ReinitialisationLosesTheChangeOfTheStoredEnergy) {
  for (const double start : {0.02, 0.0, -0.01}) {
    auto particles = one(Phase::water, false);
    particles.kernel_sum[0] = 1.01;  // of a lattice sum of 1: towards a compression of 0.01
    particles.max_relative_velocity[0] = 25.0;
    particles.compression_rate[0] = 0.0;
    particles.compression[0] = start;
    particles.reinitialisation_loss[0] = 0.0;
    for_each_index(1, DensityReinitialisation<2, Double>{particles.view(), 1e-3, 1.0});
    const double end = particles.compression[0];
    EXPECT_GT(std::abs(end - start), 2e-4);
    const double due = stored(particles, start) - stored(particles, end);
    EXPECT_NEAR(particles.reinitialisation_loss[0], due, 1e-3 * std::abs(due) + 1e-12);
  }
}

}  // namespace
}  // namespace kerf::test::density_losses_test
