// SPDX-License-Identifier: Apache-2.0
// The message of a run that breaks down.
#include "simulation/breakdown.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace kerf::test {
namespace {

std::string message_of(const Breakdown& breakdown) {
  try {
    report_breakdown(breakdown);
  } catch (const UserError& error) {
    EXPECT_EQ(error.exit_code(), exit_run_failed);
    return error.what();
  }
}

TEST(Breakdown, MessageHasTimePlaceCauseAndRemedy) {
  Breakdown breakdown;
  breakdown.time = 0.0125;
  breakdown.step = 42;
  breakdown.particle = 7;
  breakdown.owner = "body 'plate'";
  breakdown.position = {0.5, -0.25, 0.0};
  breakdown.dt = 1e-12;
  breakdown.cause = "acceleration";
  breakdown.courant = 0.3;
  EXPECT_EQ(message_of(breakdown),
            "the run broke down at t = 0.0125 s, step 42: particle 7 of body 'plate' at "
            "(0.5, -0.25, 0) m needs a time step of 1e-12 s (acceleration); lower time.courant "
            "(now 0.3) or a repulsion, and look at the last frame");
  breakdown.fault = true;
  breakdown.cause = "a density of zero or less";
  EXPECT_NE(message_of(breakdown).find("m has a density of zero or less; lower"),
            std::string::npos);
}

}  // namespace
}  // namespace kerf::test
