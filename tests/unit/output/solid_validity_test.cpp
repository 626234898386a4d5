// SPDX-License-Identifier: Apache-2.0
// Flags of the balance and of solids: energy without a supply, what their hourglass control stores,
// and whether they came to rest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "output/result.hpp"

namespace kerf::test::solid_validity_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;
using State = ValidityFlag::State;

// Supplied with one joule, of which solids store a tenth.
RunOutcome outcome_with_solid() {
  RunOutcome outcome;
  outcome.balance.energy_initial = outcome.balance.kinetic = 1.0;
  outcome.balance.elastic_strain = 0.1;
  return outcome;
}

auto any_of_name(const std::string& name) {
  return Contains(Field(&ValidityFlag::name, name));
}
auto flag_of(const std::string& name, State state, const std::string& part) {
  return Contains(AllOf(Field(&ValidityFlag::name, name), Field(&ValidityFlag::state, state),
                        Field(&ValidityFlag::sentence, HasSubstr(part))));
}

// Where no energy was supplied there is nothing to compare its drift with.
TEST(BalanceValidity, TellsADriftWithoutEnergy) {
  RunOutcome outcome;
  outcome.balance.mass_now = 2.0;
  const auto nothing = flag_of("energy_drift", State::good, "No energy was supplied");
  EXPECT_THAT(validity_of(outcome), nothing);
  outcome.balance.kinetic = 1e-7;  // that of 0.3 mm/s is noise
  EXPECT_THAT(validity_of(outcome), nothing);
  outcome.balance.kinetic = 2e-3;
  EXPECT_THAT(validity_of(outcome),
              flag_of("energy_drift", State::warning, "0.002 J although none"));
}

// Water that settles gets a little energy: any share of it is small beside a motion at a tenth of
// the sound speed, for which the sound speed was made.
TEST(BalanceValidity, AnyDensityLossOfLittleEnergyIsSmall) {
  RunOutcome outcome = outcome_with_solid();
  Material water;
  water.sound_speed = 20.0;
  outcome.description.materials = {water};
  outcome.balance.dissipated_density = 0.2;
  outcome.balance.mass_now = 10.0;  // the motion has 20 J, and a twentieth of its speed 0.05 J
  EXPECT_THAT(validity_of(outcome), flag_of("density_loss", State::warning, "takes 20% of all"));
  outcome.balance.mass_now = 100.0;
  EXPECT_THAT(validity_of(outcome), flag_of("density_loss", State::good, "20% of the little"));
}

// Debris has a density too, and a case without water is not told that its water is too fast.
TEST(BalanceValidity, NamesWhoseDensityIsSmoothed) {
  RunOutcome outcome = outcome_with_solid();
  outcome.balance.dissipated_density = -0.5;
  Material solid, water;
  solid.kind = MaterialKind::elastic;
  water.kind = MaterialKind::water;
  outcome.description.materials = {solid};
  EXPECT_THAT(validity_of(outcome),
              flag_of("density_loss", State::warning,
                      "debris and nearly incompressible solids may be too fast. Give the solids "
                      "more artificial_linear, or use a finer spacing."));
  outcome.description.materials = {water};
  EXPECT_THAT(validity_of(outcome),
              flag_of("density_loss", State::warning, "the water may be too fast. Use a finer"));
  outcome.description.materials = {solid, water};
  EXPECT_THAT(validity_of(outcome),
              flag_of("density_loss", State::warning, "the water or the debris may be too fast"));
}

TEST(SolidValidity, FlagsHourglassEnergy) {
  RunOutcome outcome = outcome_with_solid();
  outcome.balance.hourglass = 0.01;
  EXPECT_THAT(validity_of(outcome), flag_of("hourglass", State::good, "holds 9.1%"));
  outcome.balance.hourglass = 0.04;
  EXPECT_THAT(validity_of(outcome), flag_of("hourglass", State::warning, "holds 29%"));
  outcome.balance.elastic_strain = outcome.balance.hourglass = 1e-9;  // of no account
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("hourglass")));
}

// What is left after an impact is ringing of short waves: the share is that of the most that solids
// store in the run, also where a run ends between the swings of a beam.
TEST(SolidValidity, ComparesHourglassEnergyWithTheMostThatIsStored) {
  RunOutcome outcome = outcome_with_solid();
  outcome.balance.elastic_strain = 0.017;
  outcome.balance.hourglass = 0.003;
  outcome.most_stored = {0.5, 0.005};
  EXPECT_THAT(validity_of(outcome), flag_of("hourglass", State::good, "holds 1% of"));
  outcome.balance.hourglass = 0.0;
  outcome.most_stored = {0.5, 0.14};
  EXPECT_THAT(validity_of(outcome), flag_of("hourglass", State::warning, "holds 28%"));
  Balance larger;
  larger.elastic_strain = 0.5;
  larger.hourglass = 0.1;
  outcome.most_stored.observe(larger);
  EXPECT_EQ(outcome.most_stored.energy, 0.6);
  EXPECT_EQ(outcome.most_stored.hourglass, 0.1);
}

TEST(SolidValidity, TellsOfSolidThatHasLeftTheDomainWhole) {
  RunOutcome outcome = outcome_with_solid();
  outcome.cut.last.fractured_mass = 0.4;
  outcome.cut.last.fractured_fraction = 0.2;
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("left_whole")));
  outcome.cut.mass_left_whole = 0.3;
  EXPECT_THAT(validity_of(outcome),
              flag_of("left_whole", State::warning, "15% of the workpiece has left the domain"));
  outcome.description.jets.clear();
  EXPECT_THAT(validity_of(outcome),
              flag_of("left_whole", State::warning, "although nothing has broken it."));
  EXPECT_NEAR(outcome.cut.broken_fraction(), 0.05, 1e-12);
}

TEST(SolidValidity, FlagsSolidsThatDidNotComeToRest) {
  RunOutcome outcome = outcome_with_solid();
  outcome.balance.dissipated_damping = 0.1;
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("relaxation")));
  outcome.description.time.relax = 1.0;
  outcome.balance.damping_peak = 1e-5;
  EXPECT_THAT(validity_of(outcome), flag_of("relaxation", State::good, "came to rest"));
  outcome.balance.damping_peak = 1e-2;
  EXPECT_THAT(validity_of(outcome), flag_of("relaxation", State::warning, "did not come to rest"));
}

// A damaged bar of nu = 0.49 acts as one of nu = 13 / 32 where it is pulled: E / (1 - nu^2) is 1.16
// times as large in plane strain as it should be, E in space 1.06 times, at the same shear modulus.
TEST(SolidValidity, TellsHowSoftSolidsAreInTension) {
  RunOutcome outcome = outcome_with_solid();
  Case& description = outcome.description;
  description.formulation = Formulation::standard;
  description.materials.resize(1);
  description.materials[0].name = "gel";
  description.bodies.resize(1);
  description.bodies[0].material = 0;
  description.bodies[0].role = Role::elastic;
  for (const auto& [dimension, poisson_ratio, part] :
       {std::tuple{2, 0.49,
                   "Where it is damaged, gel acts under tension with a Poisson's ratio of 0.41 for "
                   "0.49, so that a bar of it stretches 16% farther"},
        std::tuple{3, 0.49, "stretches 6% farther"}, std::tuple{2, 0.45, "stretches 8% farther"}}) {
    description.dimension = dimension;
    description.materials[0].poisson_ratio = poisson_ratio;
    EXPECT_THAT(validity_of(outcome), flag_of("tension", State::note, part));
  }
  description.materials[0].poisson_ratio = 0.4;
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("tension")));
}

TEST(SolidValidity, FlagsParticlesThatAreLooseFromTheStart) {
  RunOutcome outcome = outcome_with_solid();
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("loose_particles")));
  outcome.description.materials.resize(1);
  outcome.description.bodies.resize(2);
  for (Body& body : outcome.description.bodies) body.material = 0;
  outcome.description.bodies[1].name = "foil";
  outcome.loose = {{1, 3, 40}};
  EXPECT_THAT(validity_of(outcome), flag_of("loose_particles", State::warning,
                                            "3 of the 40 particles of \"foil\" have too few"));
}

TEST(SolidValidity, FlagsSolidInsideRigidBodies) {
  RunOutcome outcome = outcome_with_solid();
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("pressed_into_rigid")));
  outcome.cut.pressed_share = 0.12;
  EXPECT_THAT(validity_of(outcome),
              flag_of("pressed_into_rigid", State::warning, "12% of the workpiece was a spacing"));
}

// A neo-Hookean solid: see CheckSolids.WarnOfASolidThatThePressureOfAJetFails for its stress.
TEST(SolidValidity, FlagsASolidThatThePressureOfTheJetFails) {
  RunOutcome outcome = outcome_with_solid();
  Case& description = outcome.description;
  description.formulation = Formulation::standard;
  description.materials.resize(2);
  description.materials[0].density = 1000.0;
  Material& soft = description.materials[1];
  soft.youngs_modulus = 1e5;
  soft.poisson_ratio = 0.25;
  soft.failure_strain = 0.5;
  description.bodies.resize(1);
  description.bodies[0].role = Role::elastic;
  description.bodies[0].material = 1;
  description.bodies[0].name = "block";
  description.jets.resize(1);
  description.jets[0].material = 0;
  outcome.cut.bodies.resize(1);
  outcome.cut.bodies[0].is_in_way = true;
  const double volume = 0.2, shear = 4e4, bulk = 2e5 / 3.0;
  const double stress = shear * std::pow(volume, -5.0 / 3.0) * 2.0 / 3.0 * (1.0 - volume * volume) +
                        0.5 * bulk * (1.0 / volume - volume);
  const double limit = std::sqrt(2.0 * stress / 1000.0);  // m/s
  description.jets[0].speed = 0.98 * limit;
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("crushing")));
  description.jets[0].speed = 1.02 * limit;
  EXPECT_THAT(validity_of(outcome),
              flag_of("crushing", State::warning, "\"block\" below a fifth of its volume"));
  outcome.cut.bodies[0].is_in_way = false;
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("crushing")));
}

TEST(SolidValidity, FlagsAWorkpieceThatCrossesTheJet) {
  RunOutcome outcome = outcome_with_solid();
  Case& description = outcome.description;
  description.materials.resize(1);
  description.bodies.resize(1);
  description.bodies[0].role = Role::elastic;
  description.bodies[0].material = 0;
  description.bodies[0].name = "block";
  description.jets.resize(1);
  description.jets[0].width = 6e-3;
  description.jets[0].speed = 8.0;
  description.time.end = 0.01;
  for (const auto& [along_x, along_y, is_told] :
       {std::tuple{"-0.4", "0", true}, std::tuple{"0.2", "0", false},
        std::tuple{"0", "-5", false}}) {
    description.bodies[0].velocity = {along_x, along_y, "0"};
    if (is_told)
      EXPECT_THAT(validity_of(outcome),
                  flag_of("moving_workpiece", State::warning, "block crosses the jet"));
    else
      EXPECT_THAT(validity_of(outcome), Not(any_of_name("moving_workpiece")));
  }
}

TEST(SolidValidity, FlagsUncalibratedMaterials) {
  RunOutcome outcome = outcome_with_solid();
  outcome.description.materials.resize(2);
  outcome.description.materials[1].name = "ham";
  outcome.description.bodies.resize(2);
  for (Body& body : outcome.description.bodies) {
    body.role = Role::elastic;
    body.material = 1;
  }
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("uncalibrated")));
  outcome.description.materials[1].uncalibrated = "tensile_strength 25 kPa to 300 kPa";
  EXPECT_THAT(validity_of(outcome),
              flag_of("uncalibrated", State::warning, "only: tensile_strength 25 kPa to 300 kPa."));
  for (Body& body : outcome.description.bodies) body.fixed = true;
  EXPECT_THAT(validity_of(outcome), Not(any_of_name("uncalibrated")));
}

}  // namespace
}  // namespace kerf::test::solid_validity_test
