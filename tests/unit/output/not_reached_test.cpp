// SPDX-License-Identifier: Apache-2.0
// The flag of a run in which no water has come to a body.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/result.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {
namespace not_reached {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

auto flag() {
  return Contains(AllOf(Field(&ValidityFlag::name, "not_reached"),
                        Field(&ValidityFlag::state, ValidityFlag::State::warning),
                        Field(&ValidityFlag::sentence, HasSubstr("No water has come"))));
}

// Of a run that ends before the water comes to its body.
RunOutcome early_outcome() {
  RunOutcome outcome;
  outcome.description.materials.emplace_back();
  outcome.description.bodies.emplace_back();
  outcome.description.bodies[0].material = 0;
  outcome.description.jets.emplace_back();
  outcome.description.jets[0].standoff = 0.02;
  outcome.description.jets[0].speed = 4.0;
  outcome.time = 0.004;  // of 0.005 to the body
  outcome.balance.mass_in = 0.25;
  outcome.balance.momentum_in = {0.0, -1.0, 0.0};
  return outcome;
}

// The water has brought an impulse as soon as it has touched anything.
TEST(NotReached, IsFlaggedUntilTheWaterTouchesABody) {
  RunOutcome outcome = early_outcome();
  EXPECT_THAT(validity_of(outcome), flag());
  outcome.balance.impulse_water = {0.0, -0.1, 0.0};
  EXPECT_THAT(validity_of(outcome), Not(flag()));
}

// What a fixed body in front of the workpiece takes of the water's impulse has not come to this.
TEST(NotReached, HoldsBehindAFixedBody) {
  RunOutcome outcome;
  outcome.balance.momentum_in = {0.0, -1.0, 0.0};
  outcome.balance.impulse_water = {0.0, -0.1, 0.0};
  outcome.description.bodies.resize(2);
  outcome.cut.bodies.resize(1);
  EXPECT_TRUE(has_touched(outcome));
  outcome.description.bodies[1].fixed = true;
  EXPECT_FALSE(has_touched(outcome));
  outcome.cut.last.is_touched = true;
  EXPECT_TRUE(has_touched(outcome));
}

TEST(NotReached, IsNotSaidOfARunWithoutAJet) {
  RunOutcome outcome;
  EXPECT_THAT(validity_of(outcome), Not(flag()));
}

// The momenta of two jets cancel, the rounding errors of the forces within their water do not.
TEST(NotReached, IsFlaggedWhereOpposedJetsMeetAboveTheBody) {
  RunOutcome outcome = early_outcome();
  outcome.description.jets.push_back(outcome.description.jets.front());
  outcome.balance.mass_in *= 2.0;
  outcome.balance.momentum_in = {};
  outcome.balance.impulse_water = {3.9e-10, 5.3e-10, 0.0};
  EXPECT_THAT(validity_of(outcome), flag());
  outcome.balance.impulse_water = {0.0, -0.1, 0.0};
  EXPECT_THAT(validity_of(outcome), Not(flag()));
}

// Such a run, of water on a wall say, has nothing that could be cut.
TEST(NotReached, IsNotSaidWithoutAWorkpiece) {
  RunOutcome outcome = early_outcome();
  outcome.description.bodies[0].role = Role::rigid;
  EXPECT_THAT(validity_of(outcome), Not(flag()));
  outcome.description.bodies.clear();
  EXPECT_THAT(validity_of(outcome), Not(flag()));
  outcome.kerf.emplace();
  outcome.balance.momentum_in = {};
  outcome.balance.impulse_water = {3.9e-10, 5.3e-10, 0.0};  // of two opposed jets
  EXPECT_EQ(verdict_of(outcome), "The jet aims at no body that it could cut.");
}

}  // namespace not_reached
}  // namespace kerf
