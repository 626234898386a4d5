// SPDX-License-Identifier: Apache-2.0
// When a nozzle that starts beside a body comes over it, against the geometry of boxes and spheres.
#include "geometry/water_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "model/body.hpp"
#include "model/jet.hpp"

namespace kerf::test::water_line_test {
namespace {

constexpr double spacing = 0.02, speed = 3.0;

// x = 0 to 4, y = -2 to 0.
Body plate(double turn = 0.0) {
  Body body;
  body.spacing = spacing;
  body.shape.kind = Shape::Kind::polygon;
  const std::vector<Point> corners{{0.0, -2.0, 0.0}, {4.0, -2.0, 0.0}, {4.0, 0.0, 0.0}, {}};
  for (const Point& corner : corners)
    body.shape.vertices.push_back({corner[0] * std::cos(turn) - corner[1] * std::sin(turn),
                                   corner[0] * std::sin(turn) + corner[1] * std::cos(turn)});
  return body;
}

// A jet that aims at (-3, 0), moved towards `way`.
Jet jet_beside(double angle, const Point& way) {
  Jet jet;
  jet.width = 0.5;
  jet.standoff = 5.0;
  jet.angle = angle;
  jet.position = {-3.0, 0.0, 0.0};
  for (std::size_t a = 0; a < 3; ++a) jet.traverse[a] = speed * way[a];
  return jet;
}

// The axis leans forward over the lower corner first, backward over the upper one.
TEST(TimeBeside, OfAPlateAtAnyAngleOfTheJet) {
  const Body body = plate();
  for (const double angle : {0.0, 0.3, -0.3, 0.6, -0.6}) {
    const double lead = angle > 0.0 ? 2.0 * std::tan(angle) : 0.0;
    const double expected = (3.0 - lead + 0.5 * spacing) / speed;
    EXPECT_NEAR(time_beside(jet_beside(angle, {1.0, 0.0, 0.0}), {&body}, 5.0, 2), expected, 1e-6)
        << angle;
  }
}

TEST(TimeBeside, TurnsWithTheCase) {
  for (const double turn : {0.5, -0.8}) {
    const Body body = plate(turn);
    Jet jet = jet_beside(turn, {std::cos(turn), std::sin(turn), 0.0});
    jet.position = {-3.0 * std::cos(turn), -3.0 * std::sin(turn), 0.0};
    EXPECT_NEAR(time_beside(jet, {&body}, 5.0, 2), (3.0 + 0.5 * spacing) / speed, 1e-3) << turn;
  }
}

Body ball() {
  Body body;
  body.spacing = spacing;
  body.shape.kind = Shape::Kind::sphere;
  body.shape.radius = 2.0;
  return body;
}

TEST(TimeBeside, OfASphereBesideTheMiddle) {
  const Body body = ball();
  Jet jet = jet_beside(0.0, {1.0, 0.0, 0.0});
  jet.position = {-5.0, 0.0, 1.2};
  EXPECT_NEAR(time_beside(jet, {&body}, 9.0, 3), (5.0 - 1.6 + 0.5 * spacing) / speed, 1e-3);
  jet.position[2] = 2.1;
  EXPECT_EQ(time_beside(jet, {&body}, 9.0, 3), 0.0);  // its axis passes beside
}

// The axis is over the sphere for less than half a spacing.
TEST(TimeBeside, EndsOverABodyThatIsGrazed) {
  const Body body = ball();
  Jet jet = jet_beside(0.0, {1.0, 0.0, 0.0});
  jet.position = {-5.0, 0.0, 2.0 - 5e-6};
  const double time = time_beside(jet, {&body}, 9.0, 3);
  EXPECT_GT(time, 0.0);
  EXPECT_TRUE(std::isfinite(way_into(body, axis_line(jet, time), 3)));
}

TEST(TimeBeside, IsNoneWhereTheWaterMeetsABodyOrNever) {
  const Body body = plate();
  const auto beside = [&](const Jet& jet, double longest) {
    return time_beside(jet, {&body}, longest, 2);
  };
  Jet jet = jet_beside(0.0, {1.0, 0.0, 0.0});
  EXPECT_EQ(beside(jet, 0.9), 0.0);  // the run ends before
  EXPECT_EQ(beside(jet_beside(0.0, {-1.0, 0.0, 0.0}), 5.0), 0.0);
  EXPECT_EQ(beside(jet_beside(0.0, {}), 5.0), 0.0);
  jet.position[0] = -0.2;  // half of the water is over the edge
  EXPECT_EQ(beside(jet, 5.0), 0.0);
  jet.position[0] = 1.0;
  EXPECT_EQ(beside(jet, 5.0), 0.0);
}

}  // namespace
}  // namespace kerf::test::water_line_test
