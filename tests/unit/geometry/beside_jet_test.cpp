// SPDX-License-Identifier: Apache-2.0
#include "geometry/beside_jet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/body.hpp"
#include "model/jet.hpp"

namespace kerf {
namespace {

constexpr double most = 1e5;

Body block_from(const Point& low, const Point& high) {
  Body body;
  body.shape.kind = Shape::Kind::box;
  body.shape.box = {low, high};
  body.spacing = 0.1;
  return body;
}

Jet straight_down(double width) {
  Jet jet;
  jet.width = width;
  jet.standoff = 5.0;
  return jet;
}

TEST(BesideJet, FindsTheNearestFace) {
  const Body left = block_from({-4.0, -1.0, 0.0}, {-3.0, 0.0, 0.0}),
             right = block_from({2.0, -1.0, 0.0}, {3.0, 0.0, 0.0});
  const BesideJet found = beside_jet(straight_down(1.0), {&left, &right}, 2, most);
  EXPECT_EQ(found.body, &right);
  EXPECT_NEAR(found.distance, 1.5, 1e-9);
}

// Leaning by 45 degrees, the axis passes the corner (3, 0) at 3 / sqrt 2.
TEST(BesideJet, OfALeaningJet) {
  Jet jet = straight_down(1.0);
  jet.angle = 0.25 * std::numbers::pi;
  const Body right = block_from({3.0, 0.0, 0.0}, {4.0, 1.0, 0.0});
  const BesideJet found = beside_jet(jet, {&right}, 2, most);
  EXPECT_NEAR(found.distance, 3.0 / std::numbers::sqrt2 - 0.5, 0.1);  // within a spacing
}

TEST(BesideJet, OfNothingBehindTheNozzle) {
  const Body above = block_from({0.0, 6.0, 0.0}, {1.0, 7.0, 0.0});
  EXPECT_EQ(beside_jet(straight_down(1.0), {&above}, 2, most).body, nullptr);
}

// A slot of 1 x 6 along z: 2.5 m from a box at x = 3, and 2 m from one at z = 5.
TEST(BesideJet, OfASlot) {
  Jet jet = straight_down(1.0);
  jet.length = 6.0;
  const Body beside = block_from({3.0, -1.0, -1.0}, {4.0, 0.0, 1.0}),
             ahead = block_from({-1.0, -1.0, 5.0}, {1.0, 0.0, 6.0});
  EXPECT_NEAR(beside_jet(jet, {&beside}, 3, most).distance, 2.5, 0.02);
  EXPECT_NEAR(beside_jet(jet, {&ahead}, 3, most).distance, 2.0, 0.02);
}

}  // namespace
}  // namespace kerf
