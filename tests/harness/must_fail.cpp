// SPDX-License-Identifier: Apache-2.0
// This test fails on purpose: tests/harness/CMakeLists.txt checks that the failure is reported.
#include <gtest/gtest.h>

TEST(Harness, ReportsAFailure) {
  EXPECT_EQ(1, 2) << "this test is meant to fail";
}
