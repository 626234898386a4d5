// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "layout.hpp"

namespace kerf {
namespace {

using namespace layout;

struct Layout {
  int dimension;
  double angle;    // rad
  double breadth;  // m, of the water in the kerf

  friend std::ostream& operator<<(std::ostream& out, const Layout& of) {
    return out << of.dimension << "D at " << of.angle << " rad, " << of.breadth << " m";
  }
};

class WaterFront : public testing::TestWithParam<Layout> {
 protected:
  Case description_ = make_case(GetParam().dimension, GetParam().angle);

  Frame frame_with_water(double depth) const {
    Frame frame = make_block(GetParam().dimension);
    add_water(frame, description_, depth, GetParam().breadth);
    tilt(frame, GetParam().angle);
    return frame;
  }

  double depth_of(const Frame& frame) const {
    Frame initial = make_block(GetParam().dimension);
    tilt(initial, GetParam().angle);
    return CutMonitor(description_, initial).observe(frame).front_depth;
  }
};

// The front of a full jet lags by the tenth of a plug that must be beyond it; that of a narrower
// stream lags by more in proportion. The limit here is half of a jet width.
TEST_P(WaterFront, IsTheDepthOfTheWater) {
  const double section = GetParam().dimension == 3 ? std::pow(GetParam().breadth / jet_width, 2)
                                                   : GetParam().breadth / jet_width;
  const double lag = 0.1 * jet_width / std::min(1.0, section);
  for (const double depth : {18.0 * mm, 30.0 * mm, 41.0 * mm}) {
    const double found = depth_of(frame_with_water(depth));
    EXPECT_LE(found, depth + 1e-9);
    EXPECT_GE(found, depth - lag - water_spacing);
  }
}

TEST_P(WaterFront, DiffersByTheDistanceThatTheWaterMoved) {
  const double moved =
      depth_of(frame_with_water(37.0 * mm)) - depth_of(frame_with_water(20.0 * mm));
  EXPECT_NEAR(moved, 17.0 * mm, 1e-6 * mm);
}

// A nozzle that has moved 20 mm along x, or is moving, with its water below it.
TEST_P(WaterFront, IsMeasuredAlongTheTraverse) {
  const double angle = GetParam().angle, speed = 2.0;
  description_.jets[0].traverse = {speed * std::cos(angle), speed * std::sin(angle), 0.0};
  description_.jets[0].dwell = 1e-3;
  Frame frame = frame_with_water(30.0 * mm);
  const double expected = depth_of(frame);
  for (std::size_t row = 0; row < frame.id.size(); ++row) {
    if (frame.category[row] != Category::water) continue;
    frame.position[row][0] += 20.0 * mm * std::cos(angle);
    frame.position[row][1] += 20.0 * mm * std::sin(angle);
  }
  frame.time = 1e-3;  // before the traverse
  EXPECT_LT(depth_of(frame), 1e-9);
  frame.time = 11e-3;
  EXPECT_NEAR(depth_of(frame), expected, 1e-6);
  frame.time = 50e-3;  // later: the water behind the nozzle counts
  EXPECT_NEAR(depth_of(frame), expected, 1e-6);
}

TEST_P(WaterFront, ChangesLessThanFivePercentWhenTheLayoutIsJittered) {
  const Frame regular = frame_with_water(25.0 * mm);
  const double expected = depth_of(regular);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Frame frame = regular;
    jitter(frame, 0.3, seed);
    EXPECT_NEAR(depth_of(frame), expected, 0.05 * expected) << "seed " << seed;
  }
}

TEST_P(WaterFront, IgnoresLeakedDrops) {
  Frame frame = frame_with_water(25.0 * mm);
  const double expected = depth_of(frame);
  for (int drop = 0; drop < 8; ++drop)  // a front of a full jet needs 10 or more
    for (const double depth : {36.0 * mm, 47.0 * mm, 60.0 * mm}) {
      const double angle = GetParam().angle;
      const double x = (drop - 3.5) * mm;
      add(frame, water(description_),
          {x * std::cos(angle) + depth * std::sin(angle),
           x * std::sin(angle) - depth * std::cos(angle), 0.0});
    }
  EXPECT_DOUBLE_EQ(depth_of(frame), expected);
}

INSTANTIATE_TEST_SUITE_P(Layouts, WaterFront,
                         testing::Values(Layout{2, 0.0, jet_width}, Layout{2, 0.0, 4.0 * mm},
                                         Layout{2, 0.0, 2.0 * jet_width}, Layout{2, 0.5, jet_width},
                                         Layout{2, -0.8, jet_width}, Layout{3, 0.0, jet_width},
                                         Layout{3, 0.4, jet_width}, Layout{3, 0.0, 6.0 * mm}));

TEST(WaterFrontOfNoCut, IsZeroBeforeContact) {
  const Case description = make_case(2);
  Frame frame = make_block(2);
  CutMonitor monitor(description, frame);
  add_water(frame, description, -5.0 * mm, jet_width);
  EXPECT_EQ(monitor.observe(frame).front_depth, 0.0);
}

TEST(WaterFrontOfNoCut, IgnoresWaterOfOtherSourcesAndInsideTheNozzle) {
  const Case description = make_case(2);
  Frame frame = make_block(2);
  CutMonitor monitor(description, frame);
  const std::size_t solids = frame.position.size();
  add_water(frame, description, 25.0 * mm, jet_width);
  Frame pool = frame;
  for (std::size_t row = solids; row < pool.source.size(); ++row) pool.source[row] = 2;
  EXPECT_EQ(monitor.observe(pool).front_depth, 0.0);
  for (std::size_t row = solids; row < frame.upstream.size(); ++row) frame.upstream[row] = 1;
  EXPECT_EQ(monitor.observe(frame).front_depth, 0.0);
}

TEST(WaterFrontOfNoCut, IgnoresWaterThatRunsDownBesideTheBlock) {
  const Case description = make_case(2);
  Frame frame = make_block(2);
  CutMonitor monitor(description, frame);
  add_box(frame, water(description), {55.0 * mm, -40.0 * mm, 0.0}, {65.0 * mm, 0.0, 0.0});
  EXPECT_EQ(monitor.observe(frame).front_depth, 0.0);
}

// A jet of three particles across also has a front, which one or two leaked drops do not move.
TEST(WaterFrontOfNoCut, IsFoundForACoarseJet) {
  Case description = make_case(2);
  description.jets[0].width = 3.0 * mm;
  Frame frame = make_block(2);
  CutMonitor monitor(description, frame);
  add_water(frame, description, 20.0 * mm, 3.0 * mm);
  for (const double x : {-1.0 * mm, 1.0 * mm}) add(frame, water(description), {x, -40.0 * mm, 0.0});
  EXPECT_NEAR(monitor.observe(frame).front_depth, 20.0 * mm, 1e-6 * mm);
}

}  // namespace
}  // namespace kerf
