// SPDX-License-Identifier: Apache-2.0
#include "output/result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/material_laws.hpp"
#include "output/balance_metrics.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

RunOutcome outcome_with_jet() {
  RunOutcome outcome;
  outcome.description.jets.emplace_back();
  outcome.description.jets[0].standoff = 0.02;
  outcome.description.title = "a \"title\"";
  outcome.derived.jet_resolution = 12.0;
  outcome.derived.mach = 0.1;
  outcome.derived.solid_to_water_spacing = 1.0;
  outcome.time = 0.03;
  outcome.cut.last.front_depth = 0.0123;
  outcome.balance.momentum_in = outcome.balance.impulse_water = {0.0, -1.0, 0.0};
  outcome.balance.energy_in = 1.0;
  outcome.balance.kinetic = 1.0;
  return outcome;
}

TEST(Result, HasEveryDocumentedKey) {
  const auto result = result_of(outcome_with_jet());
  for (const char* key : {"cut_through",
                          "cut_through_time",
                          "front_speed",
                          "pieces",
                          "fractured_fraction",
                          "V_over_cR",
                          "V_over_cp",
                          "cauchy_number",
                          "regime",
                          "mass_error",
                          "momentum_error",
                          "energy_drift",
                          "steps",
                          "particles",
                          "wall_time",
                          "title",
                          "case",
                          "dimension",
                          "formulation",
                          "precision",
                          "version",
                          "compiler",
                          "device",
                          "threads",
                          "end_time",
                          "front_depth",
                          "fractured_width",
                          "kerf_width",
                          "pair_interactions",
                          "time_step_limits",
                          "balance",
                          "jet_resolution",
                          "validity",
                          "stage_times"})
    EXPECT_TRUE(result.contains(key)) << key;
  EXPECT_EQ(result.at("balance").size(), balance_terms().size());
}

TEST(Result, CutThroughTimeIsNullBeforeTheCut) {
  RunOutcome outcome = outcome_with_jet();
  EXPECT_TRUE(result_of(outcome).at("cut_through_time").is_null());
  outcome.cut.cut_through = true;
  outcome.cut.cut_through_time = 0.0221;
  EXPECT_EQ(result_of(outcome).at("cut_through_time"), 0.0221);
}

TEST(Result, StatesKindAndPositionOfTheCutThrough) {
  RunOutcome outcome = outcome_with_jet();
  EXPECT_TRUE(result_of(outcome).at("cut_through_by").is_null());
  EXPECT_TRUE(result_of(outcome).at("cut_through_place").is_null());
  outcome.cut.cut_through = outcome.cut.severed = true;
  outcome.cut.cut_through_place = {0.01, -0.02, 0.0};
  EXPECT_EQ(result_of(outcome).at("cut_through_by"), "severed");
  EXPECT_EQ(result_of(outcome).at("cut_through_place"), nlohmann::ordered_json({0.01, -0.02, 0.0}));
  outcome.cut.severed = false;
  EXPECT_EQ(result_of(outcome).at("cut_through_by"), "holed");
}

TEST(Result, HasTheProfileOfTheKerfAndOfTheOpening) {
  RunOutcome outcome = outcome_with_jet();
  outcome.kerf.emplace();
  outcome.kerf->shape.profile = {{-1e-3, 2e-3}, {0.0, 3e-3}, {1e-3, 2.5e-3}};
  outcome.kerf->opening.profile = {{0.0, 4e-3}};
  const auto result = result_of(outcome);
  const auto& profile = result.at("kerf").at("profile");
  EXPECT_EQ(profile.at("position"), nlohmann::ordered_json({-1e-3, 0.0, 1e-3}));
  EXPECT_EQ(profile.at("depth"), nlohmann::ordered_json({2e-3, 3e-3, 2.5e-3}));
  EXPECT_EQ(result.at("opening").at("profile").at("position"),
            nlohmann::ordered_json::array({0.0}));
  EXPECT_EQ(result.at("opening").at("profile").at("depth"), nlohmann::ordered_json::array({4e-3}));
}

TEST(Result, IsValidJsonForAnyNumbers) {
  RunOutcome outcome = outcome_with_jet();
  outcome.cut.front_speed = std::numeric_limits<double>::infinity();
  outcome.balance.kinetic = std::numeric_limits<double>::quiet_NaN();
  const auto read = nlohmann::json::parse(result_of(outcome).dump());
  EXPECT_TRUE(read.at("front_speed").is_null());
  EXPECT_TRUE(read.at("energy_drift").is_null());
  EXPECT_EQ(read.at("title"), "a \"title\"");
}

TEST(Verdict, DescribesTheOutcome) {
  RunOutcome outcome = outcome_with_jet();
  EXPECT_THAT(verdict_of(outcome), HasSubstr("30 ms and makes no measurable dent."));
  outcome.cut.last.fractured_mass = 1e-6;
  outcome.cut.last.cut_depth = 0.012;
  EXPECT_THAT(verdict_of(outcome), HasSubstr("; the cut is 12 mm and its front 12.3 mm deep."));
  outcome.cut.cut_through = true;
  outcome.cut.cut_through_time = 0.0221;
  outcome.cut.last.pieces = 2;
  EXPECT_EQ(verdict_of(outcome),
            "The jet cuts through after 22.1 ms; at the end the workpiece is in 2 pieces.");
  outcome.description.jets[0].traverse = {1.0, 0.0, 0.0};
  outcome.kerf.emplace();
  outcome.kerf->shape.through_share = 0.75;
  EXPECT_EQ(verdict_of(outcome),
            "The jet cuts through after 22.1 ms, and all the way down on 75% of its way so far; at "
            "the end the workpiece is in 2 pieces.");
  outcome.cut.last.pieces = 0;
  EXPECT_THAT(verdict_of(outcome), HasSubstr("larger than 5% of it is in the domain"));
  outcome.description.jets.clear();
  EXPECT_THAT(verdict_of(outcome), HasSubstr("no jet"));
}

using State = ValidityFlag::State;

auto flag(const std::string& name, State state, const std::string& part) {
  return Contains(AllOf(Field(&ValidityFlag::name, name), Field(&ValidityFlag::state, state),
                        Field(&ValidityFlag::sentence, HasSubstr(part))));
}

auto named(const std::string& name) {
  return Contains(Field(&ValidityFlag::name, name));
}

TEST(Validity, FlagsWeakRunsOnly) {
  RunOutcome outcome = outcome_with_jet();
  outcome.kerf.emplace();
  outcome.kerf->of<Leak>().water = 2.0;
  const auto good = validity_of(outcome);
  EXPECT_THAT(good, flag("resolution", State::good, "The jet is 12 particles wide."));
  EXPECT_THAT(good, flag("energy_drift", State::good, "closes to 0%"));
  EXPECT_THAT(good, flag("standoff", State::note, "no drag and no breakup"));
  EXPECT_THAT(good, flag("abrasive", State::note, "Abrasive is not modelled"));
  EXPECT_THAT(good, flag("leak", State::good, "0% of the jet's water"));
  EXPECT_THAT(good, flag("reflections", State::good, "No wave"));
  EXPECT_THAT(good, Not(named("solid_spacing")));
  EXPECT_THAT(good, Not(named("still_cutting")));
  EXPECT_THAT(good, Not(Contains(Field(&ValidityFlag::state, State::warning))));

  outcome.derived.jet_resolution = 5.0;
  outcome.derived.mach = 0.3;
  outcome.derived.solid_to_water_spacing = 2.0;
  outcome.balance.kinetic = 1.05;
  outcome.still_cutting = true;
  outcome.kerf->of<Leak>().mass = 0.1;
  const auto weak = validity_of(outcome);
  EXPECT_EQ(weak.front().name, "still_cutting");
  EXPECT_THAT(weak, flag("resolution", State::warning, "only 5 particles wide"));
  EXPECT_THAT(weak, flag("mach", State::warning, "0.3, over 0.1"));
  EXPECT_THAT(weak, flag("solid_spacing", State::warning, "2 times the water's"));
  EXPECT_THAT(weak, flag("energy_drift", State::warning, "off by 5%"));
  EXPECT_THAT(weak, flag("leak", State::warning, "5% of the jet's water"));
}

// Breaks should dissipate energy. The energy input of the outcome is one joule.
TEST(Validity, FlagsBreaksThatAddEnergy) {
  RunOutcome outcome = outcome_with_jet();
  EXPECT_THAT(validity_of(outcome), Not(named("energy_from_breaks")));  // nothing broke
  for (const auto& [dissipated, state, part] : {std::tuple{0.3, State::good, "Breaks add 0%"},
                                                {-0.01, State::good, "Breaks add 1%"},
                                                {-0.3, State::warning, "Breaks add 30%"}}) {
    outcome.balance.dissipated_fracture = dissipated;
    EXPECT_THAT(validity_of(outcome), flag("energy_from_breaks", state, part)) << dissipated;
  }
}

TEST(Validity, FlagsLargeDensityLosses) {
  RunOutcome outcome = outcome_with_jet();
  EXPECT_THAT(validity_of(outcome), Not(named("density_loss")));
  for (const auto& [lost, state, part] : {std::tuple{0.05, State::good, "takes 7% of"},
                                          {0.18, State::warning, "takes 20% of"},
                                          {-0.22, State::warning, "adds 20% of"}}) {
    outcome.balance.dissipated_density = 0.02;
    outcome.balance.dissipated_reinitialisation = lost;
    EXPECT_THAT(validity_of(outcome), flag("density_loss", state, part)) << lost;
  }
}

TEST(Validity, FlagsReflectedWaves) {
  RunOutcome outcome = outcome_with_jet();
  outcome.derived.reflection_time = 0.01;
  outcome.cut.contact_time = std::nan("");  // no contact
  EXPECT_THAT(validity_of(outcome), flag("reflections", State::good, "No wave"));
  outcome.cut.contact_time = 0.021;
  EXPECT_THAT(validity_of(outcome), flag("reflections", State::good, "No wave"));
  outcome.cut.contact_time = 0.019;
  EXPECT_THAT(validity_of(outcome), flag("reflections", State::note, "10 ms after"));
  outcome.derived.reflection_time = 0.0;  // no reflecting edge
  EXPECT_THAT(validity_of(outcome), flag("reflections", State::good, "No wave"));
}

TEST(Validity, StandoffOfAMachineIsAModelBeyondTheCoherentLength) {
  RunOutcome outcome = outcome_with_jet();
  outcome.description.machine.emplace();
  outcome.description.machine->standoff = 0.04;
  outcome.description.machine->coherent_length = 0.05;
  EXPECT_THAT(validity_of(outcome), flag("standoff", State::note, "is intact"));
  outcome.description.machine->coherent_length = 0.01;
  EXPECT_THAT(
      validity_of(outcome),
      Contains(AllOf(Field(&ValidityFlag::name, "standoff"), Field(&ValidityFlag::value, 0.04),
                     Field(&ValidityFlag::sentence, HasSubstr("follow a model")))));
}

TEST(Validity, FlagsAMaterialWithoutStrength) {
  RunOutcome outcome = outcome_with_jet();
  outcome.description.materials.resize(1);
  Material& material = outcome.description.materials[0];
  material.kind = MaterialKind::elastic;
  material.name = "jelly";
  outcome.description.bodies.resize(1);
  Body& body = outcome.description.bodies[0];
  body.role = Role::elastic;
  body.material = 0;
  EXPECT_THAT(validity_of(outcome), flag("unbreakable", State::warning, "jelly has no strength"));
  body.fixed = true;  // not part of the workpiece
  EXPECT_THAT(validity_of(outcome), Not(named("unbreakable")));
  body.fixed = false;
  material.failure_strain = 0.1;
  EXPECT_THAT(validity_of(outcome), Not(named("unbreakable")));
  material.failure_strain = 0.0;
  material.criterion = BondCriterion::principal_stress;
  EXPECT_THAT(validity_of(outcome), named("unbreakable"));
  material.laws->principal_stress.tensile_strength = 1e6;
  EXPECT_THAT(validity_of(outcome), Not(named("unbreakable")));
}

TEST(Validity, AnEnergyGivesFractureItsLength) {
  RunOutcome outcome = outcome_with_jet();
  outcome.description.materials.resize(1);
  Material& material = outcome.description.materials[0];
  material.failure_strain = 0.1;
  material.fracture_energy = 0.0;
  EXPECT_THAT(validity_of(outcome), named("length_scale"));
  material.fracture_energy = 10.0;
  EXPECT_THAT(validity_of(outcome), Not(named("length_scale")));
  material.failure_strain = 0.0;
  EXPECT_THAT(validity_of(outcome), Not(named("length_scale")));
}

TEST(Validity, IsWrittenAsFlagsWithNumbers) {
  const auto result = result_of(outcome_with_jet());
  const auto& first = result.at("validity").at(0);
  EXPECT_EQ(first.at("name"), "resolution");
  EXPECT_EQ(first.at("state"), "good");
  EXPECT_EQ(first.at("value"), 12.0);
  EXPECT_EQ(first.at("limit"), 10.0);
  EXPECT_TRUE(result.at("validity").back().at("value").is_null());
}

}  // namespace
}  // namespace kerf
