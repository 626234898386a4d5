// SPDX-License-Identifier: Apache-2.0
// Time, kind and position of the cut-through of a block, and the speed of the water front.
#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "layout.hpp"

namespace kerf {
namespace {

using namespace layout;

TEST(CutThrough, IsTheTimeOfSeparationIntoTwoPieces) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  for (int n = 0; n <= 10; ++n) {
    Frame frame = make_cut(description, 2.2 * n * mm, 4.0 * mm, n * 1e-3);
    if (n >= 7)
      change(frame, Category::fractured,
             [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
    EXPECT_EQ(monitor.observe(frame).cut_through, n >= 7);
  }
  EXPECT_TRUE(monitor.summary().cut_through);
  EXPECT_DOUBLE_EQ(monitor.summary().cut_through_time, 7e-3);
}

// The summary has the kind and the position of the front on the axis at that time, also for a
// moving nozzle.
TEST(CutThrough, StatesItsKindAndPosition) {
  for (const double angle : {0.0, 0.4}) {
    Case description = make_case(2, angle);
    description.jets[0].traverse = {2.0, 0.0, 0.0};
    description.jets[0].start = 3e-3;
    description.jets[0].dwell = 2e-3;
    Frame initial = make_block(2), frame = make_cut(description, 22.0 * mm, 4.0 * mm, 7e-3);
    change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
    tilt(initial, angle);
    tilt(frame, angle);
    CutMonitor monitor(description, initial);
    monitor.observe(frame);
    const CutSummary summary = monitor.summary();
    ASSERT_TRUE(summary.cut_through);
    EXPECT_TRUE(summary.severed);
    // Two milliseconds of travel at right angles to the jet, 2 cos(angle) m/s.
    const double c = std::cos(angle), s = std::sin(angle), way = 2.0 * c * 2e-3;
    const double depth = summary.last.front_depth;
    EXPECT_NEAR(depth, 22.0 * mm, 3.0 * mm);
    EXPECT_NEAR(summary.cut_through_place[0], depth * s + way * c, 1e-12);
    EXPECT_NEAR(summary.cut_through_place[1], -depth * c + way * s, 1e-12);
  }
  const Case description = make_case(3);
  CutMonitor monitor(description, make_block(3));
  monitor.observe(make_cut(description, thickness, 12.0 * mm, 2e-3));
  EXPECT_FALSE(monitor.summary().severed);
  EXPECT_NEAR(monitor.summary().cut_through_place[1], -thickness, solid_spacing);
}

// The block is parted as the front has passed a quarter of it, and the water comes through later.
TEST(CutThrough, TellsACrackAheadOfTheWater) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  const auto parted = [&](double depth, double time) {
    Frame frame = make_cut(description, depth, 4.0 * mm, time);
    change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
    return frame;
  };
  monitor.observe(parted(0.25 * thickness, 1e-3));
  EXPECT_TRUE(monitor.summary().cracked_ahead());
  EXPECT_NEAR(monitor.summary().front_share_at_cut, 0.25, 0.1);
  EXPECT_TRUE(std::isnan(monitor.summary().water_through_time));
  monitor.observe(parted(0.75 * thickness, 2e-3));
  EXPECT_TRUE(std::isnan(monitor.summary().water_through_time));
  monitor.observe(parted(1.2 * thickness, 3e-3));
  monitor.observe(parted(1.2 * thickness, 4e-3));
  EXPECT_EQ(monitor.summary().water_through_time, 3e-3);
  EXPECT_TRUE(monitor.summary().cracked_ahead());
  EXPECT_FALSE(monitor.summary().gave_way());
  CutMonitor late(description, make_block(2));
  late.observe(parted(0.75 * thickness, 2e-3));
  EXPECT_FALSE(late.summary().holds_at_rest_only());
}

// Water that is beyond the far face by more than half the width of the jet when the block is cut
// has pressed that face ahead.
TEST(CutThrough, AFrontBeyondTheFarFaceHasPressedItAhead) {
  const Case description = make_case(2);
  const double width = description.jets[0].width;
  for (const double beyond : {-0.1, 0.2, 1.0, 3.0}) {
    CutMonitor monitor(description, make_block(2));
    Frame frame = make_cut(description, thickness + beyond * width, 4.0 * mm, 1e-3);
    change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
    monitor.observe(frame);
    ASSERT_TRUE(monitor.summary().cut_through) << beyond;
    EXPECT_EQ(monitor.summary().gave_way(), beyond > 0.5) << beyond;
  }
}

// Halves that are pushed apart by more than the jet has removed between them.
TEST(CutThrough, AnOpeningThatIsPushedOpenIsNotRemoved) {
  const Case description = make_case(2);
  for (const double apart : {2.0 * mm, 8.0 * mm}) {
    CutMonitor monitor(description, make_block(2));
    Frame frame = make_cut(description, 0.95 * thickness, 4.0 * mm, 1e-3);
    change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
    for (std::size_t row = 0; row < frame.position.size(); ++row)
      if (frame.category[row] == Category::solid)
        frame.position[row][0] += (frame.position[row][0] > 0.0 ? 0.5 : -0.5) * apart;
    monitor.observe(frame);
    ASSERT_TRUE(monitor.summary().cut_through) << apart;
    EXPECT_NEAR(monitor.summary().removed_share_at_cut, 4.0 * mm / (4.0 * mm + apart), 0.05);
    EXPECT_EQ(monitor.summary().gave_way(), apart > 4.0 * mm) << apart;
  }
}

TEST(CutThrough, IsKeptWhenTheBlockFragmentsFurther) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  monitor.observe(make_cut(description, thickness, 4.0 * mm, 1e-3));
  Frame crumbled = make_cut(description, thickness, 200.0 * mm, 2e-3);
  const CutState state = monitor.observe(crumbled);
  EXPECT_EQ(state.pieces, 0);
  EXPECT_TRUE(state.cut_through);
  EXPECT_DOUBLE_EQ(monitor.summary().cut_through_time, 1e-3);
}

// A block with a round hole is one piece.
TEST(CutThrough, IsTheTimeWhenAHoleReachesTheBottom) {
  const Case description = make_case(3);
  CutMonitor monitor(description, make_block(3));
  CutState state = monitor.observe(make_cut(description, thickness - 8.0 * mm, 12.0 * mm, 1e-3));
  EXPECT_FALSE(state.cut_through);
  state = monitor.observe(make_cut(description, thickness, 12.0 * mm, 2e-3));
  EXPECT_EQ(state.pieces, 1);
  EXPECT_TRUE(state.cut_through);
}

TEST(CutThrough, IsNotReachedByADisplacedBlock) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  Frame frame = make_cut(description, 10.0 * mm, 12.0 * mm, 1e-3);
  move(frame, [](const Position& x) -> Position { return {x[0], x[1] - 45.0 * mm, x[2]}; });
  const CutState state = monitor.observe(frame);
  EXPECT_GT(state.front_depth, thickness);
  EXPECT_FALSE(state.cut_through);
}

TEST(CutThrough, RequiresMorePiecesThanInitially) {
  Case description = make_case(2);
  description.bodies.push_back(description.bodies[0]);
  description.bodies[1].name = "lower";
  Frame frame;
  add_box(frame, solid(0), {-50.0 * mm, -20.0 * mm, 0.0}, {50.0 * mm, 0.0, 0.0});
  add_box(frame, solid(1), {-50.0 * mm, -40.0 * mm, 0.0}, {50.0 * mm, -20.0 * mm, 0.0});
  CutMonitor monitor(description, frame);
  change(frame, Category::fractured,
         [](const Position& x) { return std::abs(x[0]) < 4.0 * mm && x[1] > -10.0 * mm; });
  add_water(frame, description, 10.0 * mm, 8.0 * mm);
  const CutState state = monitor.observe(frame);
  EXPECT_EQ(state.pieces, 2);
  EXPECT_FALSE(state.cut_through);
}

TEST(FrontSpeed, IsTheSlopeBetweenContactAndExit) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  const double speed = 2.2;
  for (int n = -10; n <= 60;
       ++n) {  // 0.5 ms apart; the front is first above the block, at the end below it
    const double time = n * 0.5e-3;
    const double below = std::max(0.0, speed * time - thickness);
    const double depth = n < 0 ? -5.0 * mm : speed * time + 4.0 * below;
    monitor.observe(make_cut(description, depth, 12.0 * mm, time));
  }
  EXPECT_NEAR(monitor.summary().front_speed, speed, 0.005 * speed);
  EXPECT_TRUE(monitor.summary().cut_through);
}

TEST(FrontSpeed, ChangesLessThanFivePercentWhenTheLayoutIsJittered) {
  const double speed = 2.2;
  for (const int dimension : {2, 3}) {
    const Case description = make_case(dimension);
    const auto measured = [&](unsigned seed) {
      CutMonitor monitor(description, make_block(dimension));
      for (int n = 0; n <= 20; ++n) {
        const double time = n * 1e-3;
        Frame frame = make_cut(description, speed * time, 12.0 * mm, time);
        if (seed > 0) jitter(frame, 0.3, seed + 100u * static_cast<unsigned>(n));
        monitor.observe(frame);
      }
      return monitor.summary().front_speed;
    };
    const double regular = measured(0);
    EXPECT_NEAR(regular, speed, 0.02 * speed);
    for (unsigned seed = 1; seed <= 5; ++seed)
      EXPECT_NEAR(measured(seed), regular, 0.05 * regular) << dimension;
  }
}

TEST(FrontSpeed, IsZeroWithoutContact) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  for (int n = 0; n < 5; ++n) monitor.observe(make_cut(description, -5.0 * mm, 0.0, n * 1e-3));
  EXPECT_EQ(monitor.summary().front_speed, 0.0);
  EXPECT_FALSE(monitor.summary().cut_through);
  EXPECT_TRUE(std::isnan(monitor.summary().cut_through_time));
}

}  // namespace
}  // namespace kerf
