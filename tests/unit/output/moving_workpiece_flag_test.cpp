// SPDX-License-Identifier: Apache-2.0
// The flag on a workpiece that crosses the jet looks at its motion relative to the nozzle.
#include "output/moving_workpiece_flag.hpp"

#include <gtest/gtest.h>

#include "model/case.hpp"

namespace kerf {
namespace {

// A block under a jet 2 mm wide, for 2 ms.
Case resting_case() {
  Case description;
  description.dimension = 2;
  description.time.end = 2e-3;
  description.bodies.emplace_back();
  description.bodies.front().name = "block";
  description.jets.emplace_back();
  description.jets.front().width = 2e-3;
  return description;
}

TEST(MovingWorkpieceFlag, IsRaisedByTheMotionRelativeToTheNozzle) {
  Case description = resting_case();
  EXPECT_FALSE(moving_workpiece_flag(description));
  description.jets.front().traverse = {2.0, 0.0, 0.0};
  EXPECT_FALSE(moving_workpiece_flag(description));
  description.bodies.front().velocity[0] = "2";
  EXPECT_FALSE(moving_workpiece_flag(description));
  description.bodies.front().velocity = {"2", "-3", "0"};  // along the jet it crosses nothing
  EXPECT_FALSE(moving_workpiece_flag(description));
  description.jets.front().traverse = {};
  const auto flag = moving_workpiece_flag(description);
  ASSERT_TRUE(flag);
  EXPECT_NEAR(flag->value.value_or(0.0), 4e-3, 1e-12);
}

TEST(MovingWorkpieceFlag, IsRaisedByAPrescribedDisplacement) {
  Case description = resting_case();
  description.bodies.front().displacement = {"1000*t^2", "0", ""};
  ASSERT_TRUE(moving_workpiece_flag(description));
  EXPECT_NEAR(moving_workpiece_flag(description)->value.value_or(0.0), 4e-3, 1e-12);
  // It returns by the end.
  description.bodies.front().displacement[0] = "0.003*sin(pi*t/0.002)";
  ASSERT_TRUE(moving_workpiece_flag(description));
  EXPECT_NEAR(moving_workpiece_flag(description)->value.value_or(0.0), 3e-3, 1e-5);
  description.bodies.front().displacement[0] = "0.0009*sin(pi*t/0.002)";
  EXPECT_FALSE(moving_workpiece_flag(description));
}

}  // namespace
}  // namespace kerf
