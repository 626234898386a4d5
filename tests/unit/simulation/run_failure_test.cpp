// SPDX-License-Identifier: Apache-2.0
// The message of a run that breaks down.
#include "simulation/run_failure.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace kerf::test {
namespace {

std::string text_of(const RunFailure& failure) {
  try {
    report_run_failure(failure);
  } catch (const UserError& error) {
    EXPECT_EQ(error.exit_code(), exit_run_failed);
    return error.what();
  }
}

TEST(RunFailure, MessageHasTimePlaceCauseAndRemedy) {
  RunFailure failure;
  failure.time = 0.0125;
  failure.step = 42;
  failure.particle = 7;
  failure.owner = "body 'plate'";
  failure.position = {0.5, -0.25, 0.0};
  failure.dt = 1e-12;
  failure.cause = "acceleration";
  failure.courant = 0.3;
  EXPECT_EQ(text_of(failure),
            "the run broke down at t = 0.0125 s, step 42: particle 7 of body 'plate' at "
            "(0.5, -0.25, 0) m needs a time step of 1e-12 s (acceleration); lower time.courant "
            "(now 0.3), and look at the last frame");
  failure.repels = true;
  EXPECT_NE(text_of(failure).find("(now 0.3) or a repulsion, and look"), std::string::npos);
  failure.fault = true;
  failure.cause = "a density of zero or less";
  EXPECT_NE(text_of(failure).find("m has a density of zero or less; lower"), std::string::npos);
  failure.never_breaks = true;
  EXPECT_NE(text_of(failure).find("zero or less; its material never breaks"), std::string::npos);
}

}  // namespace
}  // namespace kerf::test
