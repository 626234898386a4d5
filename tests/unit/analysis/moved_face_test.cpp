// SPDX-License-Identifier: Apache-2.0
// Depths and the verdict hang neither on where on its axis a jet aims nor on the motion of nozzle
// and workpiece together.
#include <gtest/gtest.h>

#include "analysis/kerf.hpp"
#include "layout.hpp"

namespace kerf {
namespace {

using namespace layout;

// The water is 22 mm deep as the block is parted.
Frame parted_block(const Case& description, double angle) {
  Frame frame = make_cut(description, 22.0 * mm, 4.0 * mm, 7e-3);
  change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
  tilt(frame, angle);
  return frame;
}

CutSummary judge_moved(const Case& description, const Frame& initial, const Frame& frame) {
  CutMonitor monitor(description, initial);
  monitor.observe(frame);
  return monitor.summary();
}

void expect_same_cut(const CutSummary& a, const CutSummary& b) {
  EXPECT_EQ(a.cut_through, b.cut_through);
  EXPECT_NEAR(a.last.front_depth, b.last.front_depth, 1e-9);
  EXPECT_NEAR(a.last.cut_depth, b.last.cut_depth, 1e-9);
  EXPECT_NEAR(a.front_share_at_cut, b.front_share_at_cut, 1e-6);
  EXPECT_NEAR(a.removed_share_at_cut, b.removed_share_at_cut, 1e-6);
}

TEST(MovedFace, ThePlaceOnTheAxisAtWhichTheJetAimsTellsNothing) {
  for (const int dimension : {2, 3})
    for (const double angle : {0.0, 0.4}) {
      const Case straight = make_case(dimension, angle);
      Frame initial = make_block(dimension);
      tilt(initial, angle);
      const Frame frame = parted_block(straight, angle);
      const CutSummary expected = judge_moved(straight, initial, frame);
      ASSERT_TRUE(expected.cut_through);
      for (const double below : {-4.0 * mm, 0.3 * mm, 4.0 * mm, 30.0 * mm, thickness}) {
        Case aimed = straight;
        aimed.jets[0].position = {below * std::sin(angle), -below * std::cos(angle), 0.0};
        aimed.jets[0].standoff += below;
        expect_same_cut(judge_moved(aimed, initial, frame), expected);
      }
    }
}

// An inclined jet enters the block as drawn, wherever the particles of its layout lie.
TEST(MovedFace, TheFaceIsThatOfTheShape) {
  const double angle = 0.6;
  for (const double shift : {0.0, 0.3, 0.7, 1.1}) {
    Case description = make_case(2, angle);
    description.bodies[0].shape.kind = Shape::Kind::box;
    description.bodies[0].shape.box = {{-50.0 * mm, -thickness, 0.0}, {50.0 * mm, 0.0, 0.0}};
    description.jets[0].position = {3.0 * mm + 5.0 * mm * std::sin(angle),
                                    -5.0 * mm * std::cos(angle), 0.0};
    description.jets[0].standoff = 25.0 * mm;
    Frame initial = make_block(2);
    move(initial, [&](const Position& x) -> Position { return {x[0] + shift * mm, x[1], x[2]}; });
    const CutMonitor monitor(description, initial);
    EXPECT_NEAR(monitor.workpiece().jet->aim[0], 3.0 * mm, 1e-9);
    EXPECT_NEAR(monitor.workpiece().jet->aim[1], 0.0, 1e-9);
  }
}

TEST(MovedFace, AWorkpieceThatComesTowardsTheNozzleIsCutAsOneAtRest) {
  for (const double angle : {0.0, 0.4}) {
    const Case description = make_case(2, angle);
    Frame initial = make_block(2);
    tilt(initial, angle);
    const Frame at_rest = parted_block(description, angle);
    const CutSummary expected = judge_moved(description, initial, at_rest);
    for (const double way : {1.0 * mm, 15.0 * mm, 60.0 * mm}) {
      Frame moved = at_rest;
      move(moved, [&](const Position& x) -> Position {
        return {x[0] - way * std::sin(angle), x[1] + way * std::cos(angle), x[2]};
      });
      expect_same_cut(judge_moved(description, initial, moved), expected);
    }
  }
}

// Before the front is below the face its water touches the workpiece, which a crack parts.
TEST(MovedFace, WaterThatTouchesTheWorkpieceHasMetIt) {
  const Case description = make_case(2);
  for (const double gap : {0.0, 5.0 * mm}) {
    Frame frame = make_block(2);
    change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
    add_water(frame, description, -gap, jet_width);
    const CutSummary summary = judge_moved(description, make_block(2), frame);
    EXPECT_NEAR(summary.last.front_depth, 0.0, 1e-9);
    EXPECT_EQ(summary.cut_through, gap == 0.0);
  }
}

// Nozzle and block move together for 10 ms: the jet has dented the block where it aimed first.
TEST(MovedFace, ADentIsMeasuredAlongThePathInTheWorkpiece) {
  for (const double common_speed : {0.0, 2.0}) {
    Case description = make_case(2);
    description.bodies[0].velocity[0] = common_speed == 0.0 ? "0" : "2";
    description.jets[0].traverse = {common_speed, 0.0, 0.0};
    const Frame initial = make_block(2);
    Frame frame = initial;
    frame.time = 10e-3;
    move(frame, [&](const Position& x) -> Position {
      const double dent = 2.0 * mm * std::exp(-std::pow(x[0] / (8.0 * mm), 2.0));
      return {x[0] + common_speed * frame.time, x[1] - dent * (1.0 + x[1] / thickness), x[2]};
    });
    CutMonitor monitor(description, initial);
    monitor.observe(frame);
    const Kerf kerf =
        measure_kerf(monitor.workpiece(), frame, kerf_conditions(description, monitor.summary()));
    EXPECT_NEAR(kerf.of<Dent>().depth, 2.0 * mm, 0.2 * mm);
  }
}

// The water of each jet counts for the contact and the verdict, that of the first for the front.
TEST(MovedFace, TheWaterOfAnyJetMeetsTheWorkpiece) {
  Case description = make_case(2);
  description.jets.push_back(description.jets[0]);
  const Frame first = parted_block(description, 0.0);
  Frame second = first;
  for (std::size_t row = 0; row < second.source.size(); ++row)
    if (second.category[row] == Category::water) ++second.source[row];
  const Frame initial = make_block(2);
  const CutSummary by_second = judge_moved(description, initial, second);
  const CutSummary by_first = judge_moved(description, initial, first);
  EXPECT_TRUE(by_first.cut_through);
  EXPECT_TRUE(by_second.cut_through);
  EXPECT_EQ(by_first.last.cut_depth, by_second.last.cut_depth);
  EXPECT_GT(by_first.last.front_depth, 0.0);
  EXPECT_EQ(by_second.last.front_depth, 0.0);
  EXPECT_FALSE(by_first.is_of_other_jet);
  EXPECT_TRUE(by_second.is_of_other_jet);
}

}  // namespace
}  // namespace kerf
