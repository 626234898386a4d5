// SPDX-License-Identifier: Apache-2.0
#include "geometry/fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "geometry/shapes.hpp"

namespace kerf {
namespace {

Body box_body(Point minimum, Point maximum, double spacing, Lattice lattice = Lattice::square) {
  Body body;
  body.shape.box = {minimum, maximum};
  body.spacing = spacing;
  body.lattice = lattice;
  return body;
}

Body round_body(Shape::Kind kind, double radius, double inner, double spacing, Lattice lattice) {
  Body body;
  body.shape.kind = kind;
  body.shape.radius = radius;
  body.shape.inner_radius = inner;
  body.shape.length = 0.01;
  body.spacing = spacing;
  body.lattice = lattice;
  return body;
}

// Checks symmetry to the last bit about 0 along an axis.
bool mirrored(const std::vector<Point>& points, std::size_t axis) {
  const std::set<Point> all(points.begin(), points.end());
  return std::all_of(points.begin(), points.end(), [&](Point point) {
    point[axis] = point[axis] == 0.0 ? 0.0 : -point[axis];
    return all.count(point) == 1;
  });
}

double nearest_distance(const std::vector<Point>& points) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      nearest =
          std::min(nearest, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1],
                                       points[i][2] - points[j][2]));
  return nearest;
}

TEST(Fill, ABoxHoldsExactlyItsParticles) {
  const Body block = box_body({-0.05, 0.0, 0.0}, {0.05, 0.05, 0.0}, 0.002);
  const auto points = fill(block, 2);
  ASSERT_EQ(points.size(), 50u * 25u);
  EXPECT_NEAR(points.front()[0], -0.049, 1e-15);
  EXPECT_NEAR(points.front()[1], 0.001, 1e-15);
  EXPECT_TRUE(mirrored(points, 0));
  EXPECT_EQ(particle_volume(block, 2), 0.002 * 0.002);
  EXPECT_EQ(fill(box_body({0, 0, 0}, {0.04, 0.02, 0.04}, 0.002), 3).size(), 20u * 10u * 20u);
  EXPECT_TRUE(mirrored(fill(box_body({-0.02, 0, -0.02}, {0.02, 0.02, 0.02}, 0.002), 3), 2));
}

// The result is independent of the rounding of length / spacing.
TEST(Fill, WholeSpacingsGiveWholeRows) {
  for (int n = 1; n < 200; ++n)
    for (const double d : {0.001, 0.0003, 0.002, 0.07}) {
      const Body row = box_body({0.1, 0.0, 0.0}, {0.1 + n * d, d, 0.0}, d);
      EXPECT_EQ(fill(row, 2).size(), static_cast<std::size_t>(n)) << n << " " << d;
    }
}

TEST(Fill, ParticlesComeInOrderOfZThenYThenX) {
  const auto points = fill(box_body({0, 0, 0}, {0.3, 0.4, 0.5}, 0.1), 3);
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return std::array{a[2], a[1], a[0]} < std::array{b[2], b[1], b[0]};
  }));
}

TEST(Fill, RoundShapesAreSymmetricAndOfTheRightArea) {
  for (const Lattice lattice : {Lattice::square, Lattice::hexagonal})
    for (const double d : {0.001, 0.00097, 0.00113, 0.0007}) {
      const Body disc = round_body(Shape::Kind::disc, 0.02, 0.0, d, lattice);
      const Body ring = round_body(Shape::Kind::ring, 0.04, 0.03, d, lattice);
      for (const Body* body : {&disc, &ring}) {
        const auto points = fill(*body, 2);
        EXPECT_TRUE(mirrored(points, 0)) << d;
        EXPECT_TRUE(mirrored(points, 1)) << d;
        const double area = static_cast<double>(points.size()) * particle_volume(*body, 2);
        const double exact = volume_estimate(body->shape, 2);
        // By Gauss's circle problem the error is of the order of the circumference times d.
        EXPECT_NEAR(area, exact, 0.02 * exact) << d;
      }
    }
}

TEST(Fill, SpheresAreSymmetric) {
  const auto points = fill(round_body(Shape::Kind::sphere, 0.01, 0.0, 0.00107, Lattice::square), 3);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_TRUE(mirrored(points, axis));
  const double volume = static_cast<double>(points.size()) * std::pow(0.00107, 3);
  EXPECT_NEAR(volume, 4.0 / 3.0 * std::numbers::pi * 1e-6, 0.03 * 4.2e-6);
}

TEST(Fill, HexagonalLatticesAreClosePacked) {
  const double d = 0.1;
  const Body plane = box_body({-1, -1, 0}, {1, 1, 0}, d, Lattice::hexagonal);
  const auto points = fill(plane, 2);
  EXPECT_NEAR(nearest_distance(points), d, 1e-12);
  EXPECT_TRUE(mirrored(points, 0));
  EXPECT_NEAR(static_cast<double>(points.size()) * particle_volume(plane, 2), 4.0, 0.03 * 4.0);
  EXPECT_NEAR(particle_volume(plane, 2), d * d * std::sqrt(3.0) / 2.0, 1e-16);

  const Body block = box_body({0, 0, 0}, {1, 1, 1}, d, Lattice::hexagonal);
  const auto packed = fill(block, 3);
  EXPECT_NEAR(nearest_distance(packed), d, 1e-12);
  EXPECT_NEAR(particle_volume(block, 3), d * d * d / std::sqrt(2.0), 1e-16);
  // A particle inside a close packing has twelve neighbours.
  int most = 0;
  for (const Point& a : packed) {
    int count = 0;
    for (const Point& b : packed)
      count += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 1.01 * d;
    most = std::max(most, count - 1);
  }
  EXPECT_EQ(most, 12);
}

TEST(Fill, OffsetShiftsTheLattice) {
  Body block = box_body({0, 0, 0}, {1, 1, 0}, 0.1);
  block.offset = {0.03, -0.02, 0.0};
  const auto points = fill(block, 2);
  EXPECT_EQ(points.size(), 100u);
  EXPECT_NEAR(points.front()[0], 0.08, 1e-15);
  EXPECT_NEAR(points.front()[1], 0.03, 1e-15);
  block.offset = {0.1, 0.0, 0.0};  // an offset of one spacing has no effect
  EXPECT_EQ(fill(block, 2).size(), 100u);
}

TEST(Fill, VisitsOnlyTheWindow) {
  const Body block = box_body({0, 0, 0}, {1, 1, 0}, 0.1);
  LatticeVisit request;
  request.window = {{0.2, 0.2, 0.0}, {0.4, 0.3, 0.0}};
  std::vector<Point> seen;
  request.visit = [&](const Point& point) {
    seen.push_back(point);
    return true;
  };
  visit_particles(block, 2, request);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_NEAR(seen[0][0], 0.25, 1e-15);
  EXPECT_NEAR(seen[1][0], 0.35, 1e-15);
}

int flagged(const Body& body, int dimension) {
  const auto flags = repelling_flags(body, fill(body, dimension), dimension);
  return static_cast<int>(std::count(flags.begin(), flags.end(), 1));
}

TEST(Repelling, OutermostLayers) {
  Body plate = box_body({0, 0, 0}, {1, 0.2, 0}, 0.1);
  const auto points = fill(plate, 2);
  const auto flags = repelling_flags(plate, points, 2);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(flags[i], points[i][1] > 0.1 ? 1 : 0);
  plate.repelling_layer = RepellingLayer::left;
  EXPECT_EQ(flagged(plate, 2), 2);
  plate.shape.box.maximum[1] = 0.5;
  plate.repelling_layer = RepellingLayer::all;
  EXPECT_EQ(flagged(plate, 2), 50 - 8 * 3);
  Body slab = box_body({0, 0, 0}, {0.6, 0.3, 0.4}, 0.1);
  EXPECT_EQ(flagged(slab, 3), 24);
  slab.repelling_layer = RepellingLayer::front;
  EXPECT_EQ(flagged(slab, 3), 18);
  slab.lattice = Lattice::hexagonal;
  slab.repelling_layer = RepellingLayer::top;
  const auto packed = fill(slab, 3);
  double highest = 0.0;
  for (const Point& point : packed) highest = std::max(highest, point[1]);
  const auto top = repelling_flags(slab, packed, 3);
  for (std::size_t i = 0; i < packed.size(); ++i)
    if (packed[i][1] > highest - 0.01) {
      EXPECT_EQ(top[i], 1);
    }
}

// The inner sides of a tank: floor and walls on the side of the water.
TEST(Repelling, InnerSidesOfATank) {
  Body tank = box_body({-0.7, -0.2, 0}, {0.7, 0.8, 0}, 0.1);
  Shape outer = tank.shape, inner = tank.shape;
  inner.box = {{-0.5, 0.0, 0.0}, {0.5, 0.9, 0.0}};
  tank.shape = Shape{};
  tank.shape.kind = Shape::Kind::difference;
  tank.shape.parts = {outer, inner};
  tank.repelling_layer = RepellingLayer::all;
  const auto points = fill(tank, 2);
  const auto flags = repelling_flags(tank, points, 2);
  int inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool floor = std::abs(points[i][0]) < 0.5 && points[i][1] > -0.1;
    const bool wall = std::abs(points[i][0]) < 0.6 && points[i][1] > 0.0;
    if (!floor && !wall) continue;
    ++inside;
    EXPECT_EQ(flags[i], 1) << points[i][0] << " " << points[i][1];
  }
  EXPECT_EQ(inside, 10 + 2 * 8);
}

}  // namespace
}  // namespace kerf
