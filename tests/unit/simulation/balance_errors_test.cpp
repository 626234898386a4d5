// SPDX-License-Identifier: Apache-2.0
// The errors of the balance of mass, momentum and energy against numbers computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/balance.hpp"

namespace kerf::test {
namespace {

TEST(Balance, MassErrorIsTheMissingShareOfTheTotalMass) {
  Balance balance;
  balance.mass_initial = 3.0;
  balance.mass_in = 1.0;
  balance.mass_out = 0.5;
  balance.mass_erased = 0.25;
  balance.mass_now = 3.25;
  EXPECT_EQ(balance.mass_error(), 0.0);
  balance.mass_now = 3.45;
  EXPECT_NEAR(balance.mass_error(), 0.05, 1e-15);
}

TEST(Balance, MomentumErrorIsRelativeToTheLargestTerm) {
  Balance balance;
  balance.momentum_initial = {1.0, 0.0, 0.0};
  balance.momentum_in = {0.0, -2.0, 0.0};
  balance.impulse_gravity = {0.0, -3.0, 0.0};
  balance.impulse_rigid = {0.0, 4.0, 0.0};
  balance.impulse_constraint = {0.5, 0.0, 0.0};
  balance.momentum_out = {0.25, 0.0, 0.0};
  balance.momentum_now = {1.25, -1.0, 0.0};
  EXPECT_NEAR(balance.momentum_error(), 0.0, 1e-15);
  balance.momentum_now[2] = 0.2;
  EXPECT_NEAR(balance.momentum_error(), 0.2 / 4.0, 1e-15);
  balance.load_scale = 10.0;  // loads that balance one another
  EXPECT_NEAR(balance.momentum_error(), 0.2 / 10.0, 1e-15);
  balance.constraint_scale = 20.0;  // clamps or rigid bodies that do so
  EXPECT_NEAR(balance.momentum_error(), 0.2 / 20.0, 1e-15);
}

// Up to twice of what was supplied, and down to half of it; at rest without energy too.
TEST(Balance, SoundEnergyIsNearWhatWasSupplied) {
  Balance balance;
  EXPECT_TRUE(balance.energy_is_sound());
  balance.mass_now = 2.0;
  balance.kinetic = 0.9e-6;  // at rest but for less than 1 mm/s
  EXPECT_TRUE(balance.energy_is_sound());
  balance.kinetic = 1.1e-6;
  EXPECT_FALSE(balance.energy_is_sound());
  balance.energy_in = 10.0;
  for (const double total : {5.1, 10.0, 19.9}) {
    balance.kinetic = total;
    EXPECT_TRUE(balance.energy_is_sound()) << total;
  }
  for (const double total : {4.9, 20.1, 1e9, std::nan("")}) {
    balance.kinetic = total;
    EXPECT_FALSE(balance.energy_is_sound()) << total;
  }
}

TEST(Balance, EnergyDriftIsInputLessStoredAndDissipated) {
  Balance balance;
  balance.energy_initial = 1.0;
  balance.energy_in = 10.0;
  balance.energy_out = 2.0;
  balance.work_gravity = -1.0;  // not part of the energy input
  balance.work_constraint = 3.0;
  balance.kinetic = 4.0;
  balance.pressure_work = 2.0;
  balance.elastic_deviatoric = 0.5;
  balance.elastic_strain = 0.25;
  balance.hourglass = 0.125;
  balance.rigid_potential = 0.125;
  balance.dissipated_artificial = 2.0;
  balance.dissipated_viscous = 1.0;
  balance.dissipated_fracture = -0.5;
  balance.dissipated_plastic = 1.0;
  balance.dissipated_density = 0.2;
  balance.dissipated_reinitialisation = 0.3;
  EXPECT_DOUBLE_EQ(balance.energy_total(), 11.0);
  EXPECT_NEAR(balance.density_loss(), 0.5 / 14.0, 1e-15);
  EXPECT_EQ(balance.energy_drift(), 0.0);
  balance.kinetic += 0.7;
  EXPECT_NEAR(balance.energy_drift(), 0.7 / 14.0, 1e-15);
  EXPECT_NEAR(balance.energy_from_breaks(), 0.5 / 14.0, 1e-15);
  balance.stored_water = 1.0;
  balance.stored_solid = 0.3;
  EXPECT_NEAR(balance.pressure_energy_gap(), -0.7 / 14.0, 1e-15);
}

}  // namespace
}  // namespace kerf::test
