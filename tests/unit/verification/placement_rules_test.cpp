// SPDX-License-Identifier: Apache-2.0
// Where a verification case may be set up, where it is, and what is said about it.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/flight.hpp"
#include "verification/placement.hpp"
#include "verification/plan.hpp"
#include "verification/worst.hpp"

namespace kerf::test::placement_test {
namespace {

TEST(Placements, DrawnAtRandomCoverTheirRangesAndDependOnTheTextAlone) {
  EXPECT_EQ(random_placement("a"), random_placement("a"));
  EXPECT_NE(random_placement("a"), random_placement("b"));
  double least = 4.0, most = -4.0;
  int mirrored = 0;
  for (int k = 0; k < 400; ++k) {
    const Placement drawn = random_placement(std::to_string(k));
    least = std::min(least, drawn.angle);
    most = std::max(most, drawn.angle);
    mirrored += drawn.mirrored;
    EXPECT_LE(std::abs(drawn.moved), 0.5);
    EXPECT_GE(drawn.standoff, 1.0);
    EXPECT_LE(drawn.standoff, 1.5);
  }
  EXPECT_LT(least, -3.0);
  EXPECT_GT(most, 3.0);
  EXPECT_NEAR(mirrored, 200, 60);
}

// The worse of two rows fails, or uses more of its tolerance; the seconds add up.
TEST(Placements, TheWorstRowIsKept) {
  Row good;
  good.case_name = "case";
  good.quantity = "speed";
  good.placement = "as written";
  good.error = 0.01;
  good.tolerance = 0.02;
  good.verdict = Verdict::pass;
  good.seconds = 1.0;
  Row worse = good;
  worse.placement = "mirrored";
  worse.error = -0.015;
  Findings written, elsewhere;
  written.rows = {good};
  elsewhere.rows = {worse};
  written.rows[0].holds_in = {"as written"};
  elsewhere.rows[0].holds_in = {"mirrored"};
  EXPECT_EQ(worst_of(written, elsewhere).rows[0].holds_in,
            (std::vector<std::string>{"as written", "mirrored"}));
  EXPECT_EQ(worst_of(written, elsewhere).rows[0].placement, "mirrored");
  EXPECT_EQ(worst_of(elsewhere, written).rows[0].placement, "mirrored");
  written.rows[0].verdict = Verdict::fail;
  EXPECT_EQ(worst_of(written, elsewhere).rows[0].placement, "as written");
  EXPECT_EQ(worst_of(written, elsewhere).rows[0].seconds, 2.0);
  written.rows[0].holds_in = {};
  EXPECT_EQ(worst_of(written, elsewhere).rows[0].holds_in, std::vector<std::string>{"mirrored"});
}

// What a case refuses is not drawn, is named with its reason, and leaves the rest; what no case
// could do is named beside it.
TEST(Placements, ACaseRefusesKindsOfMoves) {
  const Placement all{0.5, true, 0.2, 1.0};
  const VerificationCase open = flight_case("");
  EXPECT_EQ(allowed_part(open, all), (Placement{0.5, true, 0.0, 1.0}));
  EXPECT_EQ(placement_problem(open, all), "it has no jet");
  const VerificationCase closed = flight_case("[refuses]\nturned = \"it would tip over\"");
  EXPECT_EQ(allowed_part(closed, all), (Placement{0.0, true, 0.0, 1.0}));
  EXPECT_EQ(placement_problem(closed, all), "it would tip over");
  EXPECT_EQ(placement_problem(closed, {0.0, true, 0.0, 1.0}), "");
  EXPECT_EQ(allowed_text(closed, all),
            "mirrored; not turned 28.65 deg: it would tip over; not moved 0.2 d: it has no jet");
  EXPECT_EQ(placement_problem(flight_case("[refuses]\nmirrored = \"a\""), all), "a");
  EXPECT_EQ(placement_problem(flight_case("[refuses]\nmoved = \"b\""), all), "b");
  EXPECT_EQ(placement_problem(flight_case("[refuses]\nstandoff = \"c\""), {0.0, false, 0.0, 2.0}),
            "c");
  EXPECT_THROW(flight_case("[refuses]\nshifted = \"d\""), std::logic_error);
}

}  // namespace
}  // namespace kerf::test::placement_test
