// SPDX-License-Identifier: Apache-2.0
// Layouts of a case: other seeds, or nozzles elsewhere over the lattice.
#include "study/layout.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "input/read.hpp"
#include "model/case.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

TEST(Layout, MovesTheNozzleWhereNothingIsRandom) {
  const Case stated = parse_case(test::machine_case, "my.toml");
  EXPECT_FALSE(has_random_layout(stated));
  EXPECT_TRUE(has_other_layouts(stated));
  std::vector<double> shares;
  for (int layout = 0; layout < 5; ++layout) {
    Case other = stated;
    change_layout(other, layout);
    const double share =
        (other.machine->position[0] - stated.machine->position[0]) / stated.machine->spacing;
    EXPECT_NEAR(other.jets[0].position[0], other.machine->position[0], 1e-15);
    EXPECT_LE(std::abs(share), 0.5);
    for (const double known : shares) EXPECT_GT(std::abs(share - known), 0.08);
    shares.push_back(share);
  }
  EXPECT_EQ(shares[0], 0.0);
}

TEST(Layout, ChangesSeedsWhereTheLayoutIsRandom) {
  Case other = parse_case(test::machine_case, "my.toml");
  other.bodies[0].jitter = 0.2;
  const double place = other.jets[0].position[0];
  change_layout(other, 3);
  EXPECT_EQ(other.bodies[0].seed, 4u);
  EXPECT_EQ(other.jets[0].position[0], place);
  other.bodies[0].jitter = 0.0;
  other.symmetry.minimum[0] = true;
  EXPECT_FALSE(has_other_layouts(other));
}

}  // namespace
}  // namespace kerf
