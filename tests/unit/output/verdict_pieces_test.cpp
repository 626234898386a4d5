// SPDX-License-Identifier: Apache-2.0
// What the verdict says of a workpiece that is softened, torn or nearly cut, but not cut through.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/result.hpp"
#include "verdict_outcomes.hpp"

namespace kerf::test::verdict_pieces_test {
namespace {

// Softening breaks nothing as long as all bonds hold.
TEST(Verdict, SofteningIsNoBreak) {
  RunOutcome outcome = whole_outcome(1e-3, 0.0);
  outcome.balance.dissipated_fracture = 1e-3;
  outcome.has_broken_bonds = false;
  EXPECT_EQ(verdict_of(outcome),
            "The jet breaks nothing within 60 ms; it presses a dent of 1 mm into the workpiece; "
            "the solid has begun to soften.");
  outcome.kerf->of<Dent>() = {};
  EXPECT_EQ(verdict_of(outcome),
            "The jet breaks nothing within 60 ms and makes no measurable dent; the solid has begun "
            "to soften.");
  outcome.has_broken_bonds = true;
  EXPECT_THAT(verdict_of(outcome), testing::StartsWith("The jet cuts nothing within 60 ms"));
}

// What tears the workpiece without cutting it is told by the pieces, also of several at the start.
TEST(Verdict, PiecesOfAnUncutWorkpieceAreTold) {
  RunOutcome outcome = whole_outcome(0.0, 0.02);
  outcome.balance.dissipated_fracture = 1e-3;
  outcome.cut.initial_pieces = outcome.cut.last.pieces = 1;
  EXPECT_THAT(verdict_of(outcome), testing::EndsWith("8 mm of the thickness is unbroken."));
  outcome.cut.last.pieces = 3;
  EXPECT_THAT(verdict_of(outcome), testing::EndsWith("the workpiece is in 3 pieces."));
  outcome.cut.initial_pieces = 2;
  EXPECT_THAT(verdict_of(outcome), testing::EndsWith("is in 3 pieces, of 2 at the start."));
}

// A flap that stands at the face ends the kerf; whether that is 0 or rounding above it says no
// more.
TEST(Verdict, ACrackIsWithoutLossOnlyWhereNoneIs) {
  RunOutcome outcome = whole_outcome(0.0, 0.0);
  outcome.cut.cut_through = outcome.cut.severed = true;
  outcome.cut.cut_through_time = 0.02;
  outcome.cut.last.pieces = 2;
  outcome.cut.last.fractured_mass = 1.0;
  const auto sentence = [&](double depth, double loss) {
    outcome.kerf->shape.depth = depth;
    outcome.kerf->of<Removal>().share_below = loss;
    return verdict_of(outcome);
  };
  const std::string start = "The workpiece is parted after 20 ms by a crack";
  const std::string end = "; at the end the workpiece is in 2 pieces.";
  EXPECT_EQ(sentence(0.0, 0.0), start + " without loss of material in its way" + end);
  EXPECT_EQ(sentence(3e-3, 0.0), start + " below a cut of 3 mm" + end);
  for (const double depth : {0.0, 2e-4})
    EXPECT_EQ(sentence(depth, 0.76),
              start + " and by loss of 76% of the material in the way of the jet" + end);
  EXPECT_EQ(sentence(3e-3, 0.4),
            start + " below a cut of 3 mm and by loss of 40% of the material below that" + end);
}

// The particles do not resolve less than their spacing, here 2 mm.
TEST(Verdict, LessThanASpacingIsNotMeasured) {
  RunOutcome outcome = whole_outcome(0.0, 0.0);
  outcome.cut.last.fractured_mass = 1.0;
  outcome.cut.last.cut_depth = 8e-3;
  outcome.kerf->of<CutMargin>() = {-5e-4, 4e-6};
  EXPECT_EQ(verdict_of(outcome),
            "The jet does not cut through within 60 ms; the cut is 8 mm and its front 30 mm deep, "
            "and less than 2 mm of the thickness, a spacing of the particles, is unbroken.");
}

}  // namespace
}  // namespace kerf::test::verdict_pieces_test
