// SPDX-License-Identifier: Apache-2.0
// The headlines of runs in which no jet aims at a body that it could cut.
#include <gtest/gtest.h>

#include "output/result.hpp"
#include "verdict_outcomes.hpp"

namespace kerf {
namespace aimless_test {
namespace {

// A block that is fixed in the way of the jet, or beside it.
RunOutcome outcome_with_fixed(double beside) {
  RunOutcome outcome = touched_outcome();
  outcome.description.dimension = 2;
  outcome.description.jets.push_back(arriving_jet());
  Body block;
  block.name = "block";
  block.fixed = true;
  block.spacing = 1e-3;
  block.shape.box = {{beside - 0.02, -0.02, 0.0}, {beside + 0.02, 0.0, 0.0}};
  outcome.description.bodies = {block};
  outcome.time = 0.03;
  outcome.kerf.emplace();
  return outcome;
}

TEST(AimlessJet, NamesTheFixedBodyInItsWay) {
  RunOutcome outcome = outcome_with_fixed(0.0);
  EXPECT_EQ(verdict_of(outcome),
            "The jet aims at no body that it could cut: block in its way is fixed.");
  outcome.description.bodies.push_back(outcome.description.bodies.front());
  outcome.description.bodies.back().name = "plate";
  EXPECT_EQ(verdict_of(outcome),
            "The jet aims at no body that it could cut: block and plate in its way are fixed.");
  EXPECT_EQ(verdict_of(outcome_with_fixed(0.1)),
            "The jet aims at no body that it could cut at the start; its water has met one beside "
            "its way or that moved into it.");
}

TEST(RunWithoutJet, TellsWhatBecomesOfTheWorkpiece) {
  RunOutcome outcome;
  outcome.time = 0.33;
  EXPECT_EQ(verdict_of(outcome),
            "The run reached 330 ms; it has no jet, so there is nothing to cut.");
  outcome.cut.initial_pieces = outcome.cut.last.pieces = 1;
  EXPECT_EQ(
      verdict_of(outcome),
      "The run reached 330 ms without a jet; the workpiece is in one piece, as at the start.");
  outcome.cut.last.pieces = 3;
  outcome.cut.pieces_since = 0.21;
  EXPECT_EQ(verdict_of(outcome),
            "The run reached 330 ms without a jet; the workpiece is in 3 pieces, since 210 ms.");
  outcome.cut.last.fractured_mass = 1.0;
  outcome.cut.last.fractured_fraction = 0.064;
  EXPECT_EQ(verdict_of(outcome),
            "The run reached 330 ms without a jet; the workpiece is in 3 pieces, since 210 ms; "
            "6.4% of it has broken.");
}

}  // namespace
}  // namespace aimless_test
}  // namespace kerf
