// SPDX-License-Identifier: Apache-2.0
// The depth of a cut below a face with steps, one that is inclined and one that is curved.
#include <gtest/gtest.h>

#include "analysis/cut_depth.hpp"
#include "bonded_layout.hpp"

namespace kerf {
namespace cut_depth_steps {
namespace {

using namespace layout;
using Region = std::function<bool(const Position&)>;

// A block of which the layout leaves out a part, and the jet takes away another.
struct CarvedBlock {
  int dimension = 2;
  double angle = 0.0, jitter_share = 0.0;
  double side = 1.0;  // -1: mirrored

  // Returns the depth of the cut, m.
  double depth(const Region& empty, const Region& gone) const {
    const auto seen = [this](const Region& region) {
      return [this, &region](const Position& x) { return region({side * x[0], x[1], x[2]}); };
    };
    Frame before = without(make_block(dimension), seen(empty));
    for (std::size_t k = 0; k < before.id.size(); ++k) {
      before.id[k] = static_cast<std::uint32_t>(k);
      before.mass[k] = before.mass[0];
    }
    Frame after = before;
    change(after, Category::fractured, seen(gone));
    if (jitter_share > 0.0) {
      jitter(before, jitter_share, 5);
      jitter(after, jitter_share, 5);
    }
    bond(before, after);
    bond(before, before);
    const Case made = make_case(dimension, angle);
    add_water_beside_bonds(after, made, 30.0 * mm);
    tilt(before, angle);
    tilt(after, angle);
    CutMonitor monitor(made, before);
    return monitor.observe(after).cut_depth;
  }
};

std::vector<CarvedBlock> carved_blocks() {
  std::vector<CarvedBlock> all;
  for (const double angle : {0.0, 0.7, -0.3})
    for (const double jitter_share : {0.0, 0.2})
      for (const double side : {1.0, -1.0}) all.push_back({2, angle, jitter_share, side});
  all.push_back({3, 0.7, 0.2, 1.0});
  return all;
}

constexpr double slot_depth = 24.0 * mm;

// A cut from the floor of the slot, and from its end one aside below a wall.
bool is_hook(const Position& x) {
  const bool is_down = std::abs(x[0]) < 2.0 * mm && x[1] > -slot_depth - 8.0 * mm;
  return is_down || (x[0] > 0.0 && x[0] < 9.0 * mm && x[1] < -slot_depth - 4.0 * mm &&
                     x[1] > -slot_depth - 8.0 * mm);
}

TEST(CutDepthSteps, ASecondPassCountsFromTheFloorOfTheSlot) {
  for (const CarvedBlock& block : carved_blocks())
    for (const double half : {6.0 * mm, 4.0 * mm}) {
      const Region slot = [half](const Position& x) {
        return std::abs(x[0]) < half && x[1] > -slot_depth;
      };
      EXPECT_NEAR(block.depth(slot, is_hook), 8.0 * mm, 1.2 * solid_spacing) << block.angle;
      // Walls that come off from their top down are as deep as below the floor.
      const Region walls = [](const Position& x) {
        return std::abs(x[0]) < 9.0 * mm && x[1] > -slot_depth - 12.0 * mm;
      };
      EXPECT_NEAR(block.depth(slot, walls), 12.0 * mm, 1.2 * solid_spacing) << block.angle;
      EXPECT_EQ(block.depth(slot, [](const Position&) { return false; }), 0.0);
    }
}

TEST(CutDepthSteps, AStepBesideTheAxisAddsNothing) {
  const Region low = [](const Position& x) { return x[0] < 4.0 * mm && x[1] > -slot_depth; };
  for (const CarvedBlock& block : carved_blocks())
    EXPECT_NEAR(block.depth(low, is_hook), 8.0 * mm, 1.2 * solid_spacing) << block.angle;
}

// Below an inclined face a cut is as deep as on its own line: the slope is no step.
TEST(CutDepthSteps, AnInclinedFaceHasNone) {
  for (const double slope : {0.4, -1.2}) {
    const Region above = [slope](const Position& x) { return x[1] > slope * x[0] - 20.0 * mm; };
    const auto below = [slope](const Position& x) { return slope * x[0] - 20.0 * mm - x[1]; };
    // At right angles to the face.
    const Region crack = [&](const Position& x) {
      const double length = std::hypot(1.0, slope), down = below(x) / (length * length);
      return std::abs(x[0] - slope * down) * length < 3.0 * mm && std::abs(x[0]) < 9.0 * mm &&
             below(x) < 14.0 * mm;
    };
    const Region slot = [&](const Position& x) {
      return std::abs(x[0]) < 8.0 * mm && below(x) < 14.0 * mm;
    };
    const double rough = (1.2 + std::abs(slope)) * solid_spacing;
    for (const CarvedBlock& block : carved_blocks()) {
      EXPECT_NEAR(block.depth(above, slot), 14.0 * mm, rough) << slope << " " << block.angle;
      EXPECT_NEAR(block.depth(above, crack), 14.0 * mm, rough) << slope << " " << block.angle;
    }
  }
}

// Beside the jet a round bar is longer along it: the cut is no deeper than the bar under the jet.
TEST(CutDepthSteps, IsAtMostTheLengthUnderTheJet) {
  const Position centre{-16.0 * mm, -25.0 * mm, 0.0};
  const Region outside = [&](const Position& x) {
    return std::hypot(x[0] - centre[0], x[1] - centre[1]) > 24.0 * mm;
  };
  const Region all = [](const Position& x) { return std::abs(x[0]) < 12.0 * mm; };
  const double longest = 2.0 * std::sqrt(24.0 * 24.0 - 11.0 * 11.0) * mm;  // 5 mm from the axis
  for (const CarvedBlock& block : carved_blocks())
    EXPECT_NEAR(block.depth(outside, all), longest, 2.0 * solid_spacing) << block.angle;
}

}  // namespace
}  // namespace cut_depth_steps
}  // namespace kerf
