// SPDX-License-Identifier: Apache-2.0
// The headlines and flags of runs in which the first of two jets met nothing and the other cuts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/result.hpp"
#include "verdict_outcomes.hpp"

namespace kerf::test::other_jet_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

// A workpiece that is parted around a plug after 19 ms of 20 ms, with a first jet that opens at
// `start`, s.
RunOutcome outcome_cut_by_other(double start) {
  RunOutcome outcome = touched_outcome();
  outcome.description.jets = {arriving_jet(), arriving_jet()};
  outcome.description.jets.front().start = start;
  outcome.description.jets.front().name = "late";
  outcome.description.materials.resize(1);
  for (Jet& jet : outcome.description.jets) jet.material = 0;
  outcome.description.bodies.emplace_back().material = 0;
  outcome.description.bodies.front().spacing = 2e-3;
  outcome.time = 0.02;
  outcome.kerf.emplace();
  outcome.kerf->shape.thickness = 8e-3;
  outcome.cut.cut_through = outcome.cut.severed = outcome.cut.punched = true;
  outcome.cut.last.cut_through = true;
  outcome.cut.cut_through_time = 0.019;
  outcome.cut.initial_pieces = 1;
  outcome.cut.last.pieces = 3;
  outcome.cut.front_share_at_cut = 0.0;
  outcome.cut.is_of_other_jet = true;
  return outcome;
}

TEST(CutOfOtherJet, IsNotCreditedToTheFirst) {
  RunOutcome outcome = outcome_cut_by_other(0.05);
  EXPECT_EQ(verdict_of(outcome),
            "The first of 2 jets has not opened within 20 ms: it opens after 50 ms; the other one "
            "punches a plug out of the workpiece after 19 ms; the workpiece is in 3 pieces.");
  outcome = outcome_cut_by_other(0.0);
  outcome.cut.punched = false;
  EXPECT_THAT(verdict_of(outcome), HasSubstr("has met no solid within 20 ms; the other one parts"));
  outcome.cut.first_touch_time = 0.0195;
  EXPECT_THAT(verdict_of(outcome), HasSubstr("met no solid before 19.5 ms; the other one parts"));
}

TEST(CutOfOtherJet, IsFlagged) {
  RunOutcome outcome = outcome_cut_by_other(0.05);
  EXPECT_THAT(validity_of(outcome),
              Contains(AllOf(Field(&ValidityFlag::name, "other_jet"),
                             Field(&ValidityFlag::state, ValidityFlag::State::warning),
                             Field(&ValidityFlag::sentence, HasSubstr("the first, late, ")))));
  EXPECT_THAT(validity_of(outcome), Not(Contains(Field(&ValidityFlag::name, "crack_ahead"))));
  outcome.cut.is_of_other_jet = false;
  EXPECT_THAT(validity_of(outcome), Not(Contains(Field(&ValidityFlag::name, "other_jet"))));
  EXPECT_THAT(validity_of(outcome), Contains(Field(&ValidityFlag::name, "crack_ahead")));
}

// The first had met the workpiece before, but what is cut is the way of the second.
TEST(CutOfOtherJet, NamesTheJetWhoseWayIsCut) {
  RunOutcome outcome = outcome_cut_by_other(0.0);
  outcome.description.jets.back().name = "fast";
  outcome.cut.punched = false;
  outcome.cut.first_touch_time = 0.005;
  outcome.cut.cut_jet = 1;
  outcome.cut.front_share_at_cut = 0.9;
  outcome.balance.dissipated_fracture = 1.0;
  outcome.kerf->of<CutMargin>().is_whole = true;  // in the way of the first
  outcome.kerf_of_cut = outcome.kerf;
  outcome.kerf_of_cut->shape.through = true;
  EXPECT_THAT(verdict_of(outcome),
              testing::StartsWith("The second of 2 jets (fast) cuts through after 19 ms; at the "
                                  "end the workpiece is in 3 pieces."));
  outcome.kerf_of_cut->shape.through = false;
  EXPECT_THAT(verdict_of(outcome),
              HasSubstr("by a crack beside the way of the second of 2 jets (fast), where"));
  EXPECT_THAT(validity_of(outcome),
              Contains(AllOf(Field(&ValidityFlag::name, "other_jet"),
                             Field(&ValidityFlag::sentence, HasSubstr(": that of fast.")))));
}

TEST(AimlessFirstJet, IsNotCreditedWithWhatTheOtherMet) {
  RunOutcome outcome = touched_outcome();
  outcome.description.jets = {arriving_jet(), arriving_jet()};
  outcome.description.bodies.emplace_back();
  outcome.description.bodies.front().spacing = 2e-3;
  outcome.time = 0.03;
  outcome.kerf.emplace();
  outcome.balance.dissipated_fracture = 1.0;
  EXPECT_THAT(verdict_of(outcome), HasSubstr("its water has met one beside its way"));
  outcome.cut.is_of_other_jet = true;
  EXPECT_EQ(verdict_of(outcome),
            "The first of 2 jets aims at no body that it could cut at the start, and its water has "
            "met none; solid has broken under another jet.");
}

}  // namespace
}  // namespace kerf::test::other_jet_test
