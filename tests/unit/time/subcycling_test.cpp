// SPDX-License-Identifier: Apache-2.0
// The combination of steps of the water to steps of the solid.
#include "time/subcycling.hpp"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Subcycling, NumberOfSubstepsIsBounded) {
  const auto steps_of = [](int most, double dt, double longest) {
    Subcycling cycle(most);
    cycle.begin(dt, longest);
    int steps = 0;
    do {
      cycle.end_step(dt);
      ++steps;
    } while (!cycle.is_first_substep());
    return steps;
  };
  EXPECT_EQ(steps_of(8, 1.0, 3.5), 3);
  EXPECT_EQ(steps_of(8, 1.0, 100.0), 8);
  EXPECT_EQ(steps_of(1, 1.0, 100.0), 1);
  EXPECT_EQ(steps_of(8, 1.0, 1.0), 1);
  EXPECT_EQ(steps_of(8, 1.0, 0.0), 1) << "the wave speed of the solid is unknown";
}

TEST(Subcycling, PredictsToTheMiddleOfTheSolidStep) {
  Subcycling cycle(4);
  cycle.begin(2.0, 8.1);
  EXPECT_DOUBLE_EQ(cycle.length(), 8.0);
  EXPECT_DOUBLE_EQ(1.0 + cycle.prediction_time(2.0),
                   4.0);  // its position is that at the middle of the first
  cycle.end_step(2.0);
  EXPECT_TRUE(cycle.was_first_substep());
  EXPECT_DOUBLE_EQ(cycle.time_since_middle(), -2.0);
  for (int step = 1; step < 4; ++step) {
    EXPECT_FALSE(cycle.is_first_substep());
    cycle.end_step(2.0);
    EXPECT_FALSE(cycle.was_first_substep());
  }
  EXPECT_TRUE(cycle.is_first_substep());
  EXPECT_DOUBLE_EQ(cycle.time_since_middle(), 4.0);
}

TEST(Subcycling, OneSubstepHasNoPrediction) {
  Subcycling cycle(1);
  for (const double dt : {0.3, 0.7, 0.1}) {
    EXPECT_TRUE(cycle.is_first_substep());
    cycle.begin(dt, 10.0);
    EXPECT_EQ(cycle.length(), dt);
    EXPECT_EQ(cycle.take_length(), dt);
    EXPECT_EQ(cycle.prediction_time(dt), 0.0);
    cycle.end_step(dt);
    EXPECT_TRUE(cycle.was_first_substep());
    EXPECT_EQ(cycle.time_since_middle(), 0.5 * dt);
  }
}

// The step size varies with the limit of the water.
TEST(Subcycling, StepsWithinTheSolidLimitAndSumsTheirTime) {
  Subcycling cycle(8);
  const double longest = 5.0;
  double time = 0.0, recorded = 0.0, in_cycle = 0.0;
  for (int step = 0; step < 1000; ++step) {
    const StepLimit limit = cycle.limit({longest, Limit::acoustic_solid, 7});
    EXPECT_EQ(limit.particle, 7u);
    const double wanted = 1.0 + 0.5 * std::sin(0.37 * step);
    const double dt = std::min(wanted, limit.dt);
    if (cycle.is_first_substep()) {
      cycle.begin(dt, longest);
      recorded += cycle.take_length();
      in_cycle = 0.0;
    }
    in_cycle += dt;
    time += dt;
    cycle.end_step(dt);
    EXPECT_LE(in_cycle, longest * (1.0 + 1e-12));
  }
  EXPECT_NEAR(recorded, time, longest) << "except the last step and its time debt";
}

TEST(Subcycling, ResumesFromASavedState) {
  Subcycling cycle(8), other(8);
  cycle.begin(1.0, 4.5);
  cycle.end_step(1.0);
  cycle.end_step(0.9);
  other.restore(cycle.save());
  EXPECT_EQ(other.save(), cycle.save());
  EXPECT_EQ(other.is_first_substep(), cycle.is_first_substep());
  EXPECT_EQ(other.limit({4.5, Limit::acoustic_solid, 0}).dt,
            cycle.limit({4.5, Limit::acoustic_solid, 0}).dt);
}

}  // namespace
}  // namespace kerf
