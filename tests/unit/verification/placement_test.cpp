// SPDX-License-Identifier: Apache-2.0
// Cases that are turned, mirrored and moved describe the same physics; the expected positions are
// worked out here with complex numbers.
#include "verification/placement.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "geometry/nozzle.hpp"
#include "geometry/shapes.hpp"
#include "input/read.hpp"
#include "model/expression.hpp"
#include "support/flight.hpp"
#include "verification/verify.hpp"

namespace kerf {
// Names of the tests.
static void PrintTo(const Placement& placement, std::ostream* out) {
  *out << placement.text();
}
}  // namespace kerf

namespace kerf::test::placement_test {
namespace {

using Complex = std::complex<double>;

constexpr std::string_view case_text = R"TOML(
title = "two bodies, a leaning jet, probes"
dimension = 2
gravity = ["0 m/s2", "-9.8 m/s2"]
[time]
end = "1 ms"
[domain]
minimum = ["-50 mm", "-20 mm"]
maximum = ["60 mm", "70 mm"]
[[body]]
name = "block"
material = "rubber"
shape = { type = "difference", parts = [
  { type = "box", minimum = ["-20 mm", "-10 mm"], maximum = ["20 mm", "0 mm"] },
  { type = "disc", centre = ["5 mm", "-4 mm"], radius = "3 mm" } ] }
spacing = "1 mm"
velocity_expression = ["2 * x + sin(100 * y)", "exp(x) - y"]
[[body]]
name = "wedge"
role = "rigid"
shape = { type = "polygon", vertices = [["30 mm", "-10 mm"], ["40 mm", "-10 mm"], ["33 mm", "5 mm"]] }
spacing = "1 mm"
displacement_expression = ["2 * t", "sin(t)"]
[[jet]]
name = "jet"
material = "water"
speed = "5 m/s"
width = "4 mm"
angle = "20 deg"
position = ["2 mm", "0 mm"]
standoff = "30 mm"
spacing = "1 mm"
[[probe]]
name = "point"
position = ["2 mm", "1 mm"]
[[probe]]
name = "plane"
kind = "plane"
position = ["0 mm", "3 mm"]
normal = [0.6, 0.8]
)TOML";

// The place in the run of a point, or the vector of a vector, of the case as it is written.
Point in_run(const Point& x, const Placement& placement) {
  const Complex mirrored(placement.mirrored ? -x[0] : x[0], x[1]);
  const Complex result = mirrored * std::polar(1.0, placement.angle);
  return {result.real(), result.imag(), x[2]};
}

void expect_near(const Point& a, const Point& b, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "component " << k;
}

class PlacementTest : public ::testing::TestWithParam<Placement> {
 protected:
  const Case written_ = parse_case(case_text, "test");
  const Case placed_ = placed(written_, GetParam());
  std::mt19937 random_{3};

  Point random_point() {
    std::uniform_real_distribution<double> along_x(-0.03, 0.05), along_y(-0.02, 0.02);
    return {along_x(random_), along_y(random_), 0.0};
  }
};

TEST_P(PlacementTest, ShapesContainTheSamePoints) {
  int inside = 0;
  for (std::size_t b = 0; b < written_.bodies.size(); ++b)
    for (int k = 0; k < 2000; ++k) {
      const Point x = random_point();
      const bool expected = contains(written_.bodies[b].shape, x, 2);
      EXPECT_EQ(contains(placed_.bodies[b].shape, in_run(x, GetParam()), 2), expected);
      inside += expected;
    }
  EXPECT_GT(inside, 200);
}

TEST_P(PlacementTest, VelocitiesAndMotionsTurnWithTheCase) {
  const std::vector<std::string> space{"x", "y", "z"};
  const auto value = [&](const Body& body, const Point& x) {
    Point v{};
    for (std::size_t a = 0; a < 2; ++a) v[a] = Expression(body.velocity[a], space)(x);
    return v;
  };
  for (int k = 0; k < 20; ++k) {
    const Point x = random_point();
    expect_near(value(placed_.bodies[0], in_run(x, GetParam())),
                in_run(value(written_.bodies[0], x), GetParam()), 1e-12);
  }
  const auto displacement = [](const Body& body) {
    Point u{};
    for (std::size_t a = 0; a < 2; ++a)
      u[a] = Expression(body.displacement[a], {"t"}).evaluate(0.3);
    return u;
  };
  expect_near(displacement(placed_.bodies[1]), in_run({0.6, std::sin(0.3), 0.0}, GetParam()),
              1e-12);
  expect_near(placed_.gravity, in_run({0.0, -9.8, 0.0}, GetParam()), 1e-12);
}

TEST_P(PlacementTest, JetsAndProbesMoveAcrossTheJet) {
  // At right angles to the direction (sin 20 deg, -cos 20 deg) of the jet.
  const double angle = 20.0 * std::numbers::pi / 180.0, by = GetParam().moved * 1e-3;
  const Point shift{by * std::cos(angle), by * std::sin(angle), 0.0};
  const auto shifted = [&](const Point& x) {
    return in_run({x[0] + shift[0], x[1] + shift[1], 0.0}, GetParam());
  };
  expect_near(placed_.probes[0].position, shifted({0.002, 0.001, 0.0}), 1e-15);
  expect_near(placed_.probes[1].normal, in_run({0.6, 0.8, 0.0}, GetParam()), 1e-12);
  const double back = 0.03 * GetParam().standoff;
  const Nozzle nozzle(placed_.jets[0], 1000.0, 2);
  expect_near(nozzle.exit(), shifted({0.002 - back * std::sin(angle), back * std::cos(angle), 0.0}),
              1e-12);
  expect_near(nozzle.direction(), in_run({std::sin(angle), -std::cos(angle), 0.0}, GetParam()),
              1e-12);
}

TEST_P(PlacementTest, ResultsAreMappedBack) {
  const PlacementInverse inverse(written_, GetParam());
  Frame frame;
  frame.time = 0.002;
  const Point x = random_point(), v{3.0, -1.0, 0.0};
  frame.position = {in_run(x, GetParam())};
  frame.velocity = {in_run(v, GetParam())};
  Balance balance;
  balance.impulse_rigid = in_run(v, GetParam());
  const Frame back = inverse.frame(frame);
  expect_near(back.velocity[0], v, 1e-12);
  expect_near(inverse.balance(balance).impulse_rigid, v, 1e-12);
  EXPECT_NEAR(back.time, 0.002 - 0.03 * (GetParam().standoff - 1.0) / 5.0, 1e-15);
  // The jet stays, and bodies move the other way.
  const double by = std::hypot(back.position[0][0] - x[0], back.position[0][1] - x[1]);
  EXPECT_NEAR(by, std::abs(GetParam().moved) * 1e-3, 1e-15);
  const Point w = in_run(v, GetParam());
  const auto values = inverse.probe_values({7.0, w[0], w[1], w[2], w[0], w[1], w[2]});
  EXPECT_EQ(values[0], 7.0);
  for (const std::size_t first : {1u, 4u})
    expect_near({values[first], values[first + 1], values[first + 2]}, v, 1e-12);
}

TEST_P(PlacementTest, TheDomainHoldsTheTurnedOneAndTheNozzle) {
  const auto is_inside = [&](const Point& x) {
    const Box& box = placed_.domain;
    return x[0] >= box.minimum[0] - 1e-12 && x[0] <= box.maximum[0] + 1e-12 &&
           x[1] >= box.minimum[1] - 1e-12 && x[1] <= box.maximum[1] + 1e-12;
  };
  for (const double x : {-0.05, 0.06})
    for (const double y : {-0.02, 0.07}) EXPECT_TRUE(is_inside(in_run({x, y, 0.0}, GetParam())));
  EXPECT_TRUE(is_inside(Nozzle(placed_.jets[0], 1000.0, 2).exit()));
}

INSTANTIATE_TEST_SUITE_P(Placements, PlacementTest,
                         ::testing::Values(Placement{}, Placement{0.7, false, 0.0, 1.0},
                                           Placement{0.0, true, 0.3, 1.0},
                                           Placement{-2.1, true, -0.4, 3.0}));

// A case without symmetry of its own gives the same number in every placement.
TEST(Placements, ARunGivesTheSameNumbers) {
  VerificationCase flying = flight_case();
  flying.runs[0].placement = {0.5, true, 0.0, 1.0};
  const auto rows = verify(flying, false, [](const std::string&, double) {}).rows;
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].verdict, Verdict::pass) << rows[0].measured;
  EXPECT_EQ(rows[0].placement, "turned 28.65 deg, mirrored");
  EXPECT_EQ(rows[0].holds_in, std::vector<std::string>{"turned 28.65 deg, mirrored"});
}

// A bar under a traction and a body force, turned: its loads turn with it.
TEST(Placements, LoadsTurnWithTheCase) {
  Case written = parse_case(case_text, "test");
  Load load;
  load.body = "block";
  load.traction = {1e3, 200.0, 0.0};
  load.acceleration = {3.0, -1.0, 0.0};
  load.region = written.bodies[0].shape;
  written.loads = {load};
  const Placement placement{0.7, true, 0.0, 1.0};
  const Case there = placed(written, placement);
  expect_near(there.loads[0].traction, in_run(load.traction, placement), 1e-9);
  expect_near(there.loads[0].acceleration, in_run(load.acceleration, placement), 1e-12);
  const Point x{0.012, -0.003, 0.0};
  EXPECT_TRUE(contains(*there.loads[0].region, in_run(x, placement), 2));
  Balance balance;
  balance.impulse_load = in_run({3.0, -1.0, 0.0}, placement);
  expect_near(PlacementInverse(written, placement).balance(balance).impulse_load, {3.0, -1.0, 0.0},
              1e-12);
}

TEST(Placements, KeepThePartsThatACaseAllows) {
  Case description = parse_case(case_text, "test");
  const Placement all{0.5, true, 0.2, 1.4};
  EXPECT_EQ(allowed_part(description, all), all);
  description.symmetry.minimum[0] = true;
  EXPECT_EQ(allowed_part(description, all), (Placement{0.0, true, 0.2, 1.4}));
  description.jets.clear();
  EXPECT_EQ(allowed_part(description, all), (Placement{0.0, true, 0.0, 1.0}));
}

TEST(Placements, SayWhyACaseCannotBePlaced) {
  Case description = parse_case(case_text, "test");
  EXPECT_EQ(placement_problem(description, {0.5, true, 0.2, 2.0}), "");
  description.symmetry.minimum[0] = true;
  EXPECT_EQ(placement_problem(description, {0.5, false, 0.0, 1.0}), "it has symmetry planes");
  EXPECT_EQ(placement_problem(description, {0.0, true, 0.0, 1.0}), "");
  description.jets.clear();
  EXPECT_EQ(placement_problem(description, {0.0, false, 0.2, 1.0}), "it has no jet");
}

}  // namespace
}  // namespace kerf::test::placement_test
