// SPDX-License-Identifier: Apache-2.0
// A body is parted by a crack that begins in the jet, whatever the crack leaves beside it.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/cut.hpp"
#include "bonded_layout.hpp"

namespace kerf {
namespace crack_path_test {
namespace {

using namespace layout;

// What is open of a block 100 mm wide and 50 mm thick: a pocket under the jet, a gallery from its
// bottom below a loose part of the block, and a shaft beside that from face to face.
struct Crack {
  bool has_pocket = true;
  double bridge = 0.0;  // m, that stays whole below the shaft
  double angle = 0.0, jitter_share = 0.0, side = 1.0;

  bool holds(const Position& x) const {
    const double across = side * x[0];
    const bool is_pocket = std::abs(across) < 5.0 * mm && x[1] > -20.0 * mm;
    const bool is_gallery =
        across > -5.0 * mm && across < 18.0 * mm && x[1] > -26.0 * mm && x[1] < -20.0 * mm;
    const bool is_shaft = across > 12.0 * mm && across < 18.0 * mm && x[1] > -thickness + bridge;
    return is_shaft || (has_pocket && (is_pocket || is_gallery));
  }
  bool parts() const {
    const Case description = make_case(2, angle);
    Frame before = make_block(2);
    if (jitter_share > 0.0) jitter(before, jitter_share, 3);
    Frame after = before;
    change(after, Category::fractured, [this](const Position& x) { return holds(x); });
    bond(before, after);
    bond(before, before);
    add_water_beside_bonds(after, description, 20.0 * mm);
    tilt(before, angle);
    tilt(after, angle);
    CutMonitor monitor(description, before);
    monitor.observe(after);
    return monitor.summary().severed;
  }
};

std::vector<Crack> set_ups() {
  std::vector<Crack> all;
  for (const double angle : {0.0, 0.7, -0.3})
    for (const double jitter_share : {0.0, 0.3})
      for (const double side : {1.0, -1.0}) all.push_back({true, 0.0, angle, jitter_share, side});
  return all;
}

TEST(CrackPath, PartsWhereTheSolidBesideTheJetIsARestOfTheOtherSide) {
  for (const Crack& crack : set_ups())
    EXPECT_TRUE(crack.parts()) << crack.angle << " " << crack.jitter_share << " " << crack.side;
}

TEST(CrackPath, DoesNotPartABodyThatABridgeHolds) {
  for (Crack crack : set_ups()) {
    crack.bridge = 6.0 * mm;
    EXPECT_FALSE(crack.parts()) << crack.angle << " " << crack.jitter_share << " " << crack.side;
  }
}

// A part breaks off beside the jet, whose way is whole.
TEST(CrackPath, BeginsInTheSpaceOfTheJet) {
  for (Crack crack : set_ups()) {
    crack.has_pocket = false;
    EXPECT_FALSE(crack.parts()) << crack.angle << " " << crack.jitter_share << " " << crack.side;
  }
}

}  // namespace
}  // namespace crack_path_test
}  // namespace kerf
