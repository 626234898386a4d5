// SPDX-License-Identifier: Apache-2.0
// The flag on a workpiece that gives way by more than its thickness.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/result.hpp"
#include "verdict_outcomes.hpp"

namespace kerf::test::sagged_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

// A workpiece 8 mm thick that nothing breaks and that has moved by `motion`, m.
RunOutcome outcome_that_moves(double motion) {
  RunOutcome outcome = whole_outcome(0.0, motion);
  outcome.description.materials.resize(1);
  outcome.description.jets.front().material = 0;
  outcome.description.bodies.front().material = 0;
  return outcome;
}

auto sagged(const std::string& part) {
  return Contains(AllOf(Field(&ValidityFlag::name, "sagged"),
                        Field(&ValidityFlag::state, ValidityFlag::State::warning),
                        Field(&ValidityFlag::sentence, HasSubstr(part))));
}
auto no_flag() {
  return Not(Contains(Field(&ValidityFlag::name, "sagged")));
}

TEST(SaggedFlag, TellsAWorkpieceThatGivesWay) {
  EXPECT_THAT(validity_of(outcome_that_moves(7.9e-3)), no_flag());
  RunOutcome outcome = outcome_that_moves(20e-3);
  EXPECT_THAT(validity_of(outcome), sagged("given way by 20 mm, 2.5 times its thickness"));
  EXPECT_THAT(validity_of(outcome), sagged("Support it, as by a rigid body below it."));
  outcome.description.workpiece.emplace().frame = WorkpieceFrame::travelling;
  EXPECT_THAT(validity_of(outcome), sagged("Widen the window until they no longer change"));
}

// The sides of a cut on a table slide apart: a support below would change nothing.
TEST(SaggedFlag, IsNotOfSidesThatSlideApart) {
  RunOutcome outcome = outcome_that_moves(20e-3);
  outcome.kerf->of<Dent>().sag = 0.1e-3;
  outcome.kerf->of<Dent>().aside = 20e-3;
  EXPECT_THAT(validity_of(outcome), no_flag());
  EXPECT_THAT(verdict_of(outcome), HasSubstr("the workpiece has moved sideways by 20 mm"));
  outcome.kerf->of<Dent>().aside = 14e-3;
  EXPECT_THAT(verdict_of(outcome), HasSubstr("the workpiece has bent or moved by 20 mm"));
}

// What flies off after the cut has not sagged before it.
TEST(SaggedFlag, OfACutTheFrontTellsWhetherItMovedBefore) {
  RunOutcome outcome = outcome_that_moves(20e-3);
  outcome.cut.cut_through = true;
  outcome.cut.front_share_at_cut = 1.1;
  EXPECT_THAT(validity_of(outcome), no_flag());
  outcome.cut.front_share_at_cut = 3.5;
  EXPECT_THAT(validity_of(outcome), sagged("20 mm"));
}

TEST(SaggedFlag, IsNotOfABodyThatTheCaseMoves) {
  RunOutcome outcome = outcome_that_moves(20e-3);
  outcome.cut.bodies.resize(1);
  EXPECT_THAT(validity_of(outcome), sagged("20 mm"));
  outcome.description.bodies.front().velocity = {"0", "-1", "0"};
  EXPECT_THAT(validity_of(outcome), no_flag());
}

}  // namespace
}  // namespace kerf::test::sagged_test
