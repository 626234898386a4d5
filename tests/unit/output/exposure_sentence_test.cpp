// SPDX-License-Identifier: Apache-2.0
// What is said of a cut that holds of a nozzle at rest only: the headline, its flags and the feed.
#include "output/exposure_sentence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/result.hpp"

namespace kerf::test::exposure_sentence_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// A plate of 1 mm under a jet that stands for one of 0.1 m/s; cut through after 1.34 us.
RunOutcome cut_plate(double share) {
  RunOutcome outcome;
  Case& description = outcome.description;
  Jet& jet = description.jets.emplace_back();
  jet.width = 1e-3;
  jet.speed = 100.0;
  description.materials.resize(1);
  description.bodies.emplace_back().material = 0;
  description.machine.emplace().motion = NozzleMotion::standing;
  description.machine->traverse_speed = 0.1;
  description.workpiece.emplace().size = {0.02, 1e-3, 0.0};
  outcome.kerf.emplace();
  KerfShape& shape = outcome.kerf->shape;
  shape.depth = shape.thickness = 1e-3;
  shape.through = true;
  shape.through_share = 1.0;
  outcome.cut.cut_through = outcome.cut.severed = true;
  outcome.cut.cut_through_time = 1.34e-6;
  outcome.cut.front_share_at_cut = share;
  outcome.cut.last.cut_through = true;
  outcome.cut.last.cut_depth = 1e-3;
  outcome.cut.last.front_depth = 0.4e-3;
  outcome.cut.last.fractured_mass = 1e-6;
  outcome.cut.last.pieces = 2;
  outcome.balance.momentum_in = outcome.balance.impulse_water = {0.0, -1.0, 0.0};
  outcome.exposure.emplace();
  outcome.exposure->thickness = 1e-3;
  outcome.exposure->simulated = 5e-6;
  outcome.exposure->shortest = 3e-3;
  outcome.exposure->longest = 9e-3;
  outcome.exposure->depth_high = 1e-3;
  outcome.exposure->possible_feed = 100.0;
  return outcome;
}

RunOutcome uncertain_plate(double share) {
  RunOutcome outcome = cut_plate(share);
  outcome.exposure->is_uncertain = true;
  outcome.exposure->greatest_feed = 0.0;
  outcome.exposure->depth_low = 9e-6;
  return outcome;
}

TEST(ExposureSentence, ACrackAheadOfTheWaterIsNoCutByTheJet) {
  RunOutcome outcome = uncertain_plate(0.009);
  EXPECT_EQ(verdict_of(outcome),
            "The workpiece is parted after 1.34 us by a crack ahead of the water, which is 400 um "
            "deep at the end; at the end the workpiece is in 2 pieces. A moving nozzle leaves the "
            "crack of its first impact behind, so no feed is certain: one of 100 mm/s may cut "
            "through; the cut is possible up to 100 m/s.");
  outcome.cut.water_through_time = 6.6e-6;
  EXPECT_THAT(verdict_of(outcome),
              StartsWith("The workpiece is parted after 1.34 us by a crack ahead of the water, "
                         "which is through after 6.6 us; "));
  EXPECT_THAT(validity_of(outcome),
              Contains(AllOf(Field(&ValidityFlag::name, "crack_ahead"),
                             Field(&ValidityFlag::sentence, HasSubstr("had passed 0.9% of its")))));
  outcome.exposure.reset();
  EXPECT_THAT(verdict_of(outcome), HasSubstr("this says nothing about a feed of 100 mm/s."));
}

TEST(ExposureSentence, WhatGivesWayIsNotCertain) {
  RunOutcome outcome = uncertain_plate(3.3);
  EXPECT_THAT(verdict_of(outcome),
              AllOf(StartsWith("The jet cuts through after 1.34 us; "),
                    HasSubstr("What gives way evades a moving nozzle, so no feed is certain"),
                    Not(HasSubstr("certain up to"))));
  const auto has_flag = Contains(Field(&ValidityFlag::name, "gave_way"));
  EXPECT_THAT(validity_of(outcome), has_flag);
  outcome.description.machine->traverse_speed = 0.0;
  EXPECT_THAT(validity_of(outcome), Not(has_flag));
}

TEST(ExposureSentence, WaterThatIsThroughMakesAFeedCertain) {
  RunOutcome outcome = cut_plate(0.9);
  outcome.exposure->depth_low = 1e-3;
  outcome.exposure->greatest_feed = 50.0;
  EXPECT_EQ(exposure_sentence(outcome),
            " A feed of 100 mm/s, which exposes each point for 3 ms or more, cuts through; the cut "
            "is certain up to 50 m/s and possible up to 100 m/s.");
  outcome.exposure->exponent = 0.5;  // the run ended before it was through
  EXPECT_THAT(exposure_sentence(outcome),
              AllOf(HasSubstr("carried over 3.3 decades"), Not(HasSubstr("certain"))));
  outcome.exposure->depth_low = 0.7e-3;
  EXPECT_THAT(exposure_sentence(outcome),
              AllOf(HasSubstr("may cut through: the run ended before its water was through"),
                    Not(HasSubstr("deep"))));
}

// A run that ends with its front below a workpiece that is not cut, or with a front at rest, says
// nothing of its feed, nor that it does not cut.
TEST(ExposureSentence, WhatTheRunDoesNotShowIsNotDenied) {
  RunOutcome outcome = cut_plate(1.0);
  outcome.cut.cut_through = outcome.cut.last.cut_through = false;
  outcome.cut.last.front_depth = 2.3e-3;
  outcome.cut.front_share_at_end = 2.3;
  outcome.exposure->depth_high = outcome.exposure->possible_feed = Exposure::none;
  EXPECT_EQ(
      exposure_sentence(outcome),
      " The front is below a workpiece that is not cut through yet: this says nothing about a "
      "feed of 100 mm/s; a later end may show the cut.");
  EXPECT_THAT(validity_of(outcome),
              Contains(AllOf(Field(&ValidityFlag::name, "gave_way"),
                             Field(&ValidityFlag::sentence, HasSubstr("not cut through")))));
  outcome.cut.last.front_depth = 0.6e-3;
  outcome.exposure->depth_low = 0.5e-3;
  EXPECT_THAT(exposure_sentence(outcome),
              AllOf(HasSubstr("The front rests at the end of the run"),
                    HasSubstr("a depth of 500 um at least"), Not(HasSubstr("does not cut"))));
}

TEST(ExposureSentence, AJetInDropsLeavesGaps) {
  RunOutcome outcome = cut_plate(0.9);
  outcome.exposure->depth_low = 1e-3;
  outcome.exposure->greatest_feed = 0.05;
  EXPECT_THAT(exposure_sentence(outcome), Not(HasSubstr("drops")));
  outcome.exposure->has_pauses = true;
  outcome.exposure->pausing_feed = 0.05;
  EXPECT_THAT(exposure_sentence(outcome),
              AllOf(HasSubstr("may cut through; the cut is certain up to 50 mm/s"),
                    HasSubstr("broken up into drops"), HasSubstr("faster than 50 mm/s")));
}

// A nozzle that is said to stand at a feed by which it would leave its jet meanwhile.
TEST(ExposureSentence, AForcedRestIsTold) {
  RunOutcome outcome = cut_plate(0.9);
  outcome.exposure->depth_low = 0.5e-3;
  const auto moves = HasSubstr("At this feed the nozzle moves by");
  EXPECT_THAT(exposure_sentence(outcome), Not(moves));
  outcome.description.machine->traverse_speed = 50.0;  // 2 mm in the 40 us of a passage
  EXPECT_THAT(
      exposure_sentence(outcome),
      HasSubstr("At this feed the nozzle moves by 2 widths of its jet while that could pass "
                "the workpiece: the cut may be deeper than this"));
  outcome.exposure->depth_low = 1e-3;
  EXPECT_THAT(exposure_sentence(outcome), Not(moves));
}

// Flaps that bend out of the way are not removed, and the way between them is open.
TEST(ExposureSentence, TheOpenShareOfTheWayIsTold) {
  RunOutcome outcome = cut_plate(1.0);
  outcome.description.machine->motion = NozzleMotion::travelling;
  outcome.description.jets[0].traverse = {0.1, 0.0, 0.0};
  outcome.exposure.reset();
  outcome.kerf->shape.through_share = outcome.kerf->opening.through_share = 0.37;
  EXPECT_THAT(verdict_of(outcome), HasSubstr("on 37% of its way so far; "));
  outcome.kerf->opening.through_share = 1.0;
  EXPECT_THAT(verdict_of(outcome),
              HasSubstr("on 37% of its way so far (100% is open, as it lies at the end); "));
}

}  // namespace
}  // namespace kerf::test::exposure_sentence_test
