// SPDX-License-Identifier: Apache-2.0
#include "geometry/lattice_angle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/fill.hpp"
#include "geometry/graded_fill.hpp"
#include "geometry/plane_turn.hpp"

namespace kerf {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double plate_spacing = 0.001;

Shape polygon_of(std::vector<std::array<double, 2>> vertices) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  shape.vertices = std::move(vertices);
  shape.depth_minimum = -0.004;
  shape.depth_maximum = 0.003;
  return shape;
}

// 30 x 14 spacings, not centred at the origin, turned.
Shape plate_at(double angle) {
  Shape shape = polygon_of({{0.012, -0.003}, {0.042, -0.003}, {0.042, 0.011}, {0.012, 0.011}});
  turn_corners(shape.vertices, PlaneTurn(angle));
  return shape;
}

Body oriented(const Shape& shape, int dimension = 2) {
  Body body;
  body.shape = shape;
  body.spacing = plate_spacing;
  body.lattice_follows_faces = true;
  orient_lattices({&body}, {}, dimension);
  return body;
}

// The greatest distance of a point from the nearest of the others.
double farthest_from(const std::vector<Point>& points, const std::vector<Point>& others) {
  double farthest = 0.0;
  for (const Point& point : points) {
    double nearest = 1.0;
    for (const Point& other : others)
      nearest = std::min(nearest,
                         std::hypot(point[0] - other[0], point[1] - other[1], point[2] - other[2]));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

std::vector<Point> turned_back(std::vector<Point> points, double angle) {
  const PlaneTurn turn(angle);
  for (Point& point : points) point = turn.back(point);
  return points;
}

TEST(LatticeAngle, ATurnedPlateHasTheParticlesOfAPlateAlongTheAxes) {
  const auto straight = fill(oriented(plate_at(0.0)), 2);
  ASSERT_EQ(straight.size(), 30u * 14u);
  for (int k = 1; k < 72; ++k) {
    const double angle = (5.0 * k + 0.3) * degree;
    const Body body = oriented(plate_at(angle));
    EXPECT_NEAR(body.lattice_angle, std::remainder(angle, 90.0 * degree), 1e-9) << angle;
    const auto points = turned_back(fill(body, 2), angle);
    ASSERT_EQ(points.size(), straight.size()) << angle;
    EXPECT_LT(farthest_from(points, straight), 1e-9 * plate_spacing) << angle;
  }
}

TEST(LatticeAngle, AnExtrudedPlateIsTurnedAboutItsThirdAxis) {
  const auto straight = fill(oriented(plate_at(0.0), 3), 3);
  ASSERT_EQ(straight.size(), 30u * 14u * 7u);
  const auto points = turned_back(fill(oriented(plate_at(-31.0 * degree), 3), 3), -31.0 * degree);
  ASSERT_EQ(points.size(), straight.size());
  EXPECT_LT(farthest_from(points, straight), 1e-9 * plate_spacing);
}

TEST(LatticeAngle, AGradedPlateIsGradedAlikeAtAnyAngle) {
  const auto graded = [](double angle) {
    Body body = oriented(plate_at(angle));
    body.grading.levels = 2;
    body.grading.width = 0.004;
    Grading::Line line;
    const PlaneTurn turn(angle);
    line.origin = turn(Point{0.020, 0.0, 0.0});
    line.direction = turn(Point{0.0, 1.0, 0.0});
    line.radius = 0.002;
    body.grading.lines.push_back(line);
    return body;
  };
  const Body straight = graded(0.0), inclined = graded(27.0 * degree);
  EXPECT_EQ(count_levels(inclined, 2), count_levels(straight, 2));
  std::vector<Point> points, others;
  for (const auto& particle : fill_levels(inclined, 2)) points.push_back(particle.position);
  for (const auto& particle : fill_levels(straight, 2)) others.push_back(particle.position);
  EXPECT_LT(farthest_from(turned_back(points, 27.0 * degree), others), 1e-9 * plate_spacing);
}

TEST(LatticeAngle, TheDirectionOfMostOfTheFacesCounts) {
  // A block with one bevelled corner, and a thin plate with a slanted end.
  EXPECT_EQ(angle_of_faces(polygon_of({{0, 0}, {4, 0}, {4, 2}, {3, 3}, {0, 3}})), 0.0);
  Shape plate = polygon_of({{0, 0}, {10, 0}, {11, 1}, {0, 1}});
  turn_corners(plate.vertices, PlaneTurn(20.0 * degree));
  EXPECT_NEAR(angle_of_faces(plate), 20.0 * degree, 1e-12);
}

TEST(LatticeAngle, SymmetricShapesKeepTheAxes) {
  // A wedge, a funnel and a regular hexagon have two or three directions of one length.
  EXPECT_EQ(angle_of_faces(polygon_of({{-1, 0}, {1, 0}, {0, -5}})), 0.0);
  EXPECT_EQ(angle_of_faces(polygon_of({{-1, 0}, {-4, 9}, {4, 9}, {1, 0}})), 0.0);
  std::vector<std::array<double, 2>> hexagon;
  for (int k = 0; k < 6; ++k)
    hexagon.push_back({std::cos((60 * k + 7) * degree), std::sin((60 * k + 7) * degree)});
  EXPECT_EQ(angle_of_faces(polygon_of(hexagon)), 0.0);
  Shape disc;
  disc.kind = Shape::Kind::disc;
  disc.radius = 0.01;
  EXPECT_EQ(angle_of_faces(disc), 0.0);
}

TEST(LatticeAngle, ACylinderAcrossZHasItsAxisAlongTheLattice) {
  Shape cylinder;
  cylinder.kind = Shape::Kind::disc;
  cylinder.radius = 0.004;
  cylinder.length = 0.020;
  cylinder.axis = {0.0, 1.0, 0.0};
  EXPECT_EQ(angle_of_faces(cylinder), 0.0);
  const auto straight = fill(oriented(cylinder, 3), 3);
  const PlaneTurn turn(97.0 * degree);
  cylinder.axis = turn(cylinder.axis);
  EXPECT_NEAR(angle_of_faces(cylinder), 7.0 * degree, 1e-12);
  const auto points = turned_back(fill(oriented(cylinder, 3), 3), 97.0 * degree);
  ASSERT_EQ(points.size(), straight.size());
  EXPECT_LT(farthest_from(points, straight), 1e-9 * plate_spacing);
  cylinder.axis = {0.0, 0.0, 1.0};
  EXPECT_EQ(angle_of_faces(cylinder), 0.0);
}

TEST(LatticeAngle, APlateWithAHoleHasTheLatticeOfThePlate) {
  Shape hole;
  hole.kind = Shape::Kind::disc;
  hole.centre = PlaneTurn(33.0 * degree)({0.027, 0.004, 0.0});
  hole.radius = 0.003;
  Shape drilled;
  drilled.kind = Shape::Kind::difference;
  drilled.parts = {plate_at(33.0 * degree), hole};
  const Body body = oriented(drilled);
  EXPECT_NEAR(body.lattice_angle, 33.0 * degree, 1e-12);
  const auto plate = fill(oriented(plate_at(33.0 * degree)), 2);
  const auto points = fill(body, 2);
  EXPECT_LT(points.size(), plate.size());
  EXPECT_LT(farthest_from(points, plate), 1e-9 * plate_spacing);
}

TEST(LatticeAngle, JoinedBodiesHaveTheAngleOfTheBodyThatTheyAreJoinedTo) {
  Body plate = oriented(plate_at(12.0 * degree)), clamp = plate, hard = plate;
  plate.name = "plate";
  clamp.shape = polygon_of({{0, 0}, {1, 0}, {0, 1}});
  clamp.joined_to = "plate";
  hard.name = "hard";
  hard.lattice_follows_faces = false;
  hard.lattice_angle = 0.1;
  orient_lattices({&clamp, &plate, &hard}, {}, 2);
  EXPECT_NEAR(clamp.lattice_angle, 12.0 * degree, 1e-12);
  EXPECT_EQ(hard.lattice_angle, 0.1);
  clamp.joined_to = "hard";
  orient_lattices({&clamp, &plate, &hard}, {}, 2);
  EXPECT_EQ(clamp.lattice_angle, 0.1);
}

TEST(LatticeAngle, ABodyAtASymmetryPlaneKeepsTheAxes) {
  Body body = oriented(plate_at(12.0 * degree));
  SymmetryPlanes symmetry;
  symmetry.planes.minimum[0] = true;
  symmetry.domain = {{0.02, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  orient_lattices({&body}, symmetry, 2);
  EXPECT_EQ(body.lattice_angle, 0.0);
  symmetry.domain.minimum[0] = 0.0;
  orient_lattices({&body}, symmetry, 2);
  EXPECT_NEAR(body.lattice_angle, 12.0 * degree, 1e-12);
}

TEST(LatticeAngle, AWindowIsAlongTheAxesOfTheCase) {
  const Body body = oriented(plate_at(40.0 * degree));
  const auto all = fill(body, 2);
  LatticeVisit request;
  request.window = {{0.012, 0.010, 0.0}, {0.022, 0.030, 0.0}};
  std::size_t expected = 0, found = 0;
  for (const Point& point : all)
    expected += point[0] >= 0.012 && point[0] <= 0.022 && point[1] >= 0.010 && point[1] <= 0.030;
  request.visit = [&](const Point&) {
    ++found;
    return true;
  };
  visit_particles(body, 2, request);
  EXPECT_GT(expected, 20u);
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace kerf
