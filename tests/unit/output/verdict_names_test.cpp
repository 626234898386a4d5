// SPDX-License-Identifier: Apache-2.0
// What the headline says of solid that has left, of jets beside planes and of bodies in the cut.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "verdict_outcomes.hpp"

namespace kerf {
namespace {

// Solid that flows out of the domain takes its bonds with it, and nothing has broken them.
TEST(Verdict, WhatLeavesTheDomainWholeIsNotBroken) {
  RunOutcome outcome = whole_outcome(1e-3, 0.0);
  outcome.has_broken_bonds = false;
  outcome.balance.dissipated_fracture = 1e-3;
  outcome.cut.last.fractured_mass = outcome.cut.mass_left_whole = 0.1;
  outcome.cut.last.fractured_fraction = 0.16;
  EXPECT_EQ(verdict_of(outcome),
            "The jet breaks nothing within 60 ms; it presses a dent of 1 mm into the workpiece; "
            "16% of the workpiece has left the domain unbroken.");
}

// A jet beside a plane has an image, which the same case without the plane states.
TEST(Verdict, OfAHalfNamesBothJets) {
  RunOutcome outcome = whole_outcome(0.0, 0.0);
  Jet& jet = outcome.description.jets[0];
  jet.width = 1e-3;
  jet.position[0] = 6e-3;
  outcome.description.symmetry.minimum[0] = true;
  EXPECT_THAT(verdict_of(outcome), testing::StartsWith("The first of 2 jets breaks nothing"));
  jet.position[0] = 0.0;
  EXPECT_THAT(verdict_of(outcome), testing::StartsWith("The jet breaks nothing"));
}

// The cut has passed beside a body that stands in the way.
TEST(Verdict, NamesWhatStandsWhereTheCutHasPassed) {
  RunOutcome outcome = whole_outcome(0.0, 0.0);
  outcome.description.bodies.push_back(outcome.description.bodies[0]);
  outcome.description.bodies[1].name = "bone";
  outcome.cut.last.fractured_mass = 1.0;
  outcome.cut.last.cut_depth = 8e-3;
  outcome.cut.last.front_depth = 7e-3;
  KerfLayer bone;
  bone.body = 1;
  bone.top = 2e-3;
  bone.unbroken = 3.5e-3;
  bone.verdict.is_in_way = true;
  outcome.kerf->layers = {bone};
  EXPECT_THAT(verdict_of(outcome),
              testing::HasSubstr("; the cut is 8 mm deep beside bone and its front 7 mm deep"));
  // There is nothing beside a layer that fills the way of the jet.
  outcome.kerf->layers[0].left = -1.0;
  outcome.kerf->layers[0].right = 1.0;
  EXPECT_THAT(verdict_of(outcome), testing::Not(testing::HasSubstr("beside bone")));
  outcome.kerf->layers[0].left = 0.0;
  outcome.kerf->layers[0].top = 8e-3;
  EXPECT_THAT(verdict_of(outcome), testing::HasSubstr("; the cut is 8 mm and its front 7 mm deep"));
}

}  // namespace
}  // namespace kerf
