// SPDX-License-Identifier: Apache-2.0
// The depth of a cut in blocks with known cuts, cracks, cavities and dents.
#include "analysis/cut_depth.hpp"

#include <gtest/gtest.h>

#include "bonded_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

// A block under a jet whose water fills a dent of 20 mm; the frame is stretched.
struct DentedBlock {
  double angle = 0.0, jitter_share = 0.0, stretch = 1.0;
  unsigned seed = 1;

  // Sets the share of bonds that each particle has lost.
  static void add_damage(const Frame& before, const Breaks& breaks, Frame& after) {
    Column damage;
    damage.name = "damage";
    for (std::size_t a = 0; a < before.id.size(); ++a) {
      double all = 0.0, lost = 0.0;
      for (std::size_t b = 0; b < before.id.size(); ++b) {
        const Position &x = before.position[a], &y = before.position[b];
        if (a == b || std::hypot(x[0] - y[0], x[1] - y[1]) >= bond_length * solid_spacing) continue;
        all += 1.0;
        lost += breaks(x, y) ? 1.0 : 0.0;
      }
      damage.values.push_back(static_cast<float>(lost / all));
    }
    damage.values.resize(after.id.size(), 0.0f);
    after.columns.push_back(damage);
  }

  // Returns the depth of the cut in a frame in which `breaks` are broken and `fractured` are
  // fractured, and after it in one in which all is whole again.
  double depth(const Breaks& breaks, const std::function<bool(const Position&)>& fractured) const {
    Frame before = make_block(2);
    if (jitter_share > 0.0) jitter(before, jitter_share, seed);
    Frame after = before;
    if (fractured) change(after, Category::fractured, fractured);
    bond(before, after, breaks);
    bond(before, before);
    move(after, [&](const Position& x) -> Position {
      return {stretch * x[0], stretch * x[1], 0.0};
    });
    const Case made = make_case(2, angle);
    add_water_beside_bonds(after, made, 20.0 * mm * stretch);
    add_damage(before, breaks, after);
    tilt(before, angle);
    tilt(after, angle);
    CutMonitor monitor(made, before);
    const double depth = monitor.observe(after).cut_depth;
    EXPECT_GT(monitor.history().back().front_depth, 10.0 * mm);
    EXPECT_EQ(monitor.observe(before).cut_depth, depth);  // what was cut stays cut
    return depth;
  }
};

std::vector<DentedBlock> dented_blocks() {
  std::vector<DentedBlock> all;
  unsigned seed = 1;
  for (const double angle : {0.0, 0.7})
    for (const double jitter_share : {0.0, 0.2})
      for (const double stretch : {1.0, 2.5}) all.push_back({angle, jitter_share, stretch, seed++});
  return all;
}

Breaks crack_between(double low, double high) {
  return [=](const Position& x, const Position& y) {
    const double middle = -(x[1] + y[1]) / 2.0;
    return (x[0] < 0.0) != (y[0] < 0.0) && middle > low && middle < high;
  };
}

TEST(CutDepth, ADentIsNone) {
  // One bond of a particle in the face below the jet.
  for (const DentedBlock& block : dented_blocks()) {
    int broken = 0;
    std::pair<Position, Position> only;
    const Breaks one = [&](const Position& x, const Position& y) {
      const bool is_near = std::abs(x[0]) < 2.0 * mm && x[1] > -3.0 * mm && y[1] < x[1];
      if (is_near && broken++ == 0) only = {x, y};
      return broken > 0 &&
             ((x == only.first && y == only.second) || (y == only.first && x == only.second));
    };
    EXPECT_EQ(block.depth(breaks_nothing, {}), 0.0);
    EXPECT_EQ(block.depth(one, {}), 0.0);
    EXPECT_GT(broken, 0);
  }
}

TEST(CutDepth, IsThatOfASlotOrACrackAsLaidOut) {
  for (const DentedBlock& block : dented_blocks()) {
    const auto slot = [](const Position& x) {
      return std::abs(x[0]) < 6.0 * mm && x[1] > -16.0 * mm;
    };
    EXPECT_NEAR(block.depth(breaks_nothing, slot), 16.0 * mm, solid_spacing);
    EXPECT_NEAR(block.depth(crack_between(-1.0, 30.0 * mm), {}), 30.0 * mm, 1.5 * solid_spacing);
  }
}

TEST(CutDepth, BreaksWithinAWholeSkinAreNone) {
  const auto cavity = [](const Position& x) {
    return std::abs(x[0]) < 4.0 * mm && x[1] > -30.0 * mm && x[1] < -12.0 * mm;
  };
  const auto aside = [](const Position& x) { return x[0] > 20.0 * mm && x[1] > -30.0 * mm; };
  for (const DentedBlock& block : dented_blocks()) {
    EXPECT_EQ(block.depth(breaks_nothing, cavity), 0.0);
    EXPECT_EQ(block.depth(crack_between(12.0 * mm, 60.0 * mm), {}), 0.0);
    EXPECT_EQ(block.depth(breaks_nothing, aside), 0.0);
  }
}

}  // namespace
}  // namespace kerf
