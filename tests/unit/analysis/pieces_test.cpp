// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "layout.hpp"

namespace kerf {
namespace {

using namespace layout;

int pieces_of(const Case& description, const Frame& initial, const Frame& frame) {
  return CutMonitor(description, initial).observe(frame).pieces;
}

class Pieces : public testing::TestWithParam<int> {
 protected:
  Case description_ = make_case(GetParam());
  Frame block_ = make_block(GetParam());

  int pieces(const Frame& frame) const { return pieces_of(description_, block_, frame); }
};

TEST_P(Pieces, AnIntactBlockIsOnePiece) {
  EXPECT_EQ(pieces(block_), 1);
}

TEST_P(Pieces, AThroughCrackOneParticleWideMakesTwo) {
  change(block_, Category::fractured,
         [](const Position& x) { return x[0] > 0.0 && x[0] < solid_spacing; });
  const Frame initial = make_block(GetParam());
  EXPECT_EQ(pieces_of(description_, initial, block_), 2);
}

// Mass, centre and velocity of both halves, without the crack.
TEST_P(Pieces, FragmentsAreTheHalves) {
  Frame frame = block_;
  change(frame, Category::fractured,
         [](const Position& x) { return x[0] > 0.0 && x[0] < solid_spacing; });
  double left = 0.0, right = 0.0;
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    if (frame.category[k] != Category::solid) continue;
    const bool is_left = frame.position[k][0] < 0.0;
    (is_left ? left : right) += static_cast<double>(frame.mass[k]);
    frame.velocity[k] = {is_left ? -3.0 : 2.0, 1.0, 0.0};
  }
  CutMonitor monitor(description_, block_);
  monitor.observe(frame);
  const std::vector<Fragment> fragments = monitor.summary().fragments;
  ASSERT_EQ(fragments.size(), 2u);
  EXPECT_GT(left, right);
  EXPECT_NEAR(fragments[0].mass, left, 1e-6 * left);
  EXPECT_NEAR(fragments[1].mass, right, 1e-6 * right);
  EXPECT_NEAR(fragments[0].velocity[0], -3.0, 1e-12);
  EXPECT_NEAR(fragments[1].velocity[0], 2.0, 1e-12);
  EXPECT_NEAR(fragments[1].velocity[1], 1.0, 1e-12);
  EXPECT_LT(fragments[0].centre[0], 0.0);
  EXPECT_GT(fragments[1].centre[0], solid_spacing);
}

TEST_P(Pieces, ACrackThatEndsOneParticleShortMakesOne) {
  Frame frame = block_;
  change(frame, Category::fractured, [](const Position& x) {
    return x[0] > 0.0 && x[0] < solid_spacing && x[1] > -thickness + solid_spacing;
  });
  EXPECT_EQ(pieces(frame), 1);
}

TEST_P(Pieces, ADiagonalCrackOneParticleWideMakesTwo) {
  Frame frame = block_;
  change(frame, Category::fractured,
         [](const Position& x) { return std::abs(x[0] - x[1] - 26.0 * mm) < 0.1 * solid_spacing; });
  EXPECT_EQ(pieces(frame), 2);
}

TEST_P(Pieces, FragmentsBelowFivePercentAreNotCounted) {
  const double half = -block_.position.front()[0] + solid_spacing / 2.0;
  Frame frame = block_;
  const auto crack_at = [&](double part) {
    frame = block_;
    const double x0 = -half + std::round(part * 2.0 * half / solid_spacing) * solid_spacing;
    change(frame, Category::fractured,
           [x0](const Position& x) { return x[0] > x0 && x[0] < x0 + solid_spacing; });
    return pieces(frame);
  };
  EXPECT_EQ(crack_at(0.04), 1);
  EXPECT_EQ(crack_at(0.10), 2);
}

TEST_P(Pieces, HalvesSeparatedWithoutFractureAreTwo) {
  Frame frame = block_;
  move(frame, [](const Position& x) -> Position {
    return {x[0] + (x[0] > 0.0 ? 1.0 : -1.0) * 1.1 * solid_spacing, x[1], x[2]};
  });
  EXPECT_EQ(pieces(frame), 2);
}

TEST_P(Pieces, AStretchedAndRotatedBlockIsOne) {
  Frame frame = block_;
  move(frame, [](const Position& x) -> Position { return {1.5 * x[0], x[1], x[2]}; });
  tilt(frame, 1.0);
  EXPECT_EQ(pieces(frame), 1);
}

TEST_P(Pieces, AreIndependentOfJitter) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Frame initial = block_;
    jitter(initial, 0.1, seed);
    Frame frame = initial;
    // The crack is chosen on the regular lattice: a jittered crack one particle wide.
    for (std::size_t row = 0; row < frame.position.size(); ++row)
      if (std::abs(block_.position[row][0] - 1.0 * mm) < 0.1 * mm)
        frame.category[row] = Category::fractured;
    EXPECT_EQ(pieces_of(description_, initial, initial), 1) << "seed " << seed;
    EXPECT_EQ(pieces_of(description_, initial, frame), 2) << "seed " << seed;
  }
}

TEST_P(Pieces, AreIndependentOfTheParticleOrder) {
  Frame frame = block_;
  change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
  EXPECT_EQ(pieces(shuffled(frame, 7)), pieces(frame));
  EXPECT_EQ(pieces_of(description_, shuffled(block_, 3), shuffled(frame, 7)), 2);
}

INSTANTIATE_TEST_SUITE_P(TwoAndThree, Pieces, testing::Values(2, 3));

TEST(PiecesOfSeveralBodies, JoinedBodiesAreOneAndTouchingOnesTwo) {
  Case description = make_case(2);
  description.bodies.push_back(description.bodies[0]);
  description.bodies[1].name = "right";
  Frame frame;
  add_box(frame, solid(0), {-50.0 * mm, -thickness, 0.0}, {0.0, 0.0, 0.0});
  add_box(frame, solid(1), {0.0, -thickness, 0.0}, {50.0 * mm, 0.0, 0.0});
  EXPECT_EQ(pieces_of(description, frame, frame), 2);
  description.bodies[1].joined_to = "block";
  EXPECT_EQ(pieces_of(description, frame, frame), 1);
}

TEST(PiecesOfSeveralBodies, AFixedClampIsNoPartOfTheWorkpiece) {
  Case description = make_case(2);
  description.bodies.push_back(description.bodies[0]);
  description.bodies[1].name = "clamp";
  description.bodies[1].fixed = true;
  description.bodies[1].joined_to = "block";
  Frame frame = make_block(2);
  add_box(frame, solid(1), {50.0 * mm, -thickness, 0.0}, {60.0 * mm, 0.0, 0.0});
  CutMonitor monitor(description, frame);
  change(frame, Category::fractured, [](const Position& x) { return x[0] > 50.0 * mm; });
  EXPECT_EQ(monitor.observe(frame).fractured_mass, 0.0);
}

TEST(PiecesOfSeveralBodies, TheSpacingsOfJoinedBodiesMayDiffer) {
  Case description = make_case(2);
  description.bodies.push_back(description.bodies[0]);
  description.bodies[1].name = "fine";
  description.bodies[1].joined_to = "block";
  Frame frame;
  add_box(frame, solid(0), {-50.0 * mm, -thickness, 0.0}, {0.0, 0.0, 0.0});
  add_box(frame, {Category::solid, 1, 1.0 * mm, 940.0}, {0.0, -thickness, 0.0},
          {50.0 * mm, 0.0, 0.0});
  EXPECT_EQ(pieces_of(description, frame, frame), 1);
}

}  // namespace
}  // namespace kerf
