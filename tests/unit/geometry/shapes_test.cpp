// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace kerf {
namespace {

constexpr double pi = std::numbers::pi;

Shape box(Point minimum, Point maximum) {
  Shape shape;
  shape.box = {minimum, maximum};
  return shape;
}

Shape round(Shape::Kind kind, double radius, double inner = 0.0, double length = 0.0) {
  Shape shape;
  shape.kind = kind;
  shape.centre = {0.3, -0.2, 0.1};
  shape.radius = radius;
  shape.inner_radius = inner;
  shape.length = length;
  shape.axis = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
  return shape;
}

Shape polygon(std::vector<std::array<double, 2>> vertices) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  shape.vertices = std::move(vertices);
  shape.depth_maximum = 0.5;
  return shape;
}

Shape of_parts(Shape::Kind kind, std::vector<Shape> parts) {
  Shape shape;
  shape.kind = kind;
  shape.parts = std::move(parts);
  return shape;
}

// Returns the share of random points that `contains` accepts, an oracle for volumes and boxes: its
// standard error is below 0.2% of the box.
double sampled_volume(const Shape& shape, int dimension) {
  const Box around = bounding_box(shape, dimension);
  Box larger = around;
  double volume = 1.0;
  for (int a = 0; a < dimension; ++a) {
    const double grow = 0.1 * (around.maximum[a] - around.minimum[a]);
    larger.minimum[a] -= grow;
    larger.maximum[a] += grow;
    volume *= larger.maximum[a] - larger.minimum[a];
  }
  std::mt19937_64 random(7);
  int inside = 0;
  constexpr int samples = 200000;
  for (int i = 0; i < samples; ++i) {
    Point point{};
    for (int a = 0; a < dimension; ++a)
      point[a] =
          std::uniform_real_distribution<double>(larger.minimum[a], larger.maximum[a])(random);
    inside += contains(shape, point, dimension);
  }
  return volume * inside / samples;
}

struct Sized {
  Shape shape;
  int dimension;
  double volume;  // closed form
};

TEST(Shapes, VolumesAreThoseOfTheClosedForms) {
  const Shape square = box({-1, -1, -1}, {1, 1, 1});
  const Shape hole = [] {
    Shape shape = round(Shape::Kind::disc, 0.5);
    return shape;
  }();
  const Sized table[] = {
      {box({0, 0, 0}, {3, 2, 0}), 2, 6.0},
      {box({0, 0, 0}, {3, 2, 0.5}), 3, 3.0},
      {round(Shape::Kind::disc, 2.0), 2, pi * 4.0},
      {round(Shape::Kind::disc, 0.5, 0.0, 3.0), 3, pi * 0.25 * 3.0},
      {round(Shape::Kind::ring, 2.0, 1.5), 2, pi * (4.0 - 2.25)},
      {round(Shape::Kind::ring, 1.0, 0.5, 2.0), 3, pi * 0.75 * 2.0},
      {round(Shape::Kind::sphere, 1.5), 3, 4.0 / 3.0 * pi * 3.375},
      {polygon({{0, 0}, {4, 0}, {0, 3}}), 2, 6.0},
      {polygon({{0, 0}, {0, 3}, {4, 0}}), 3, 3.0},
      {polygon({{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}), 2, 3.0},
      {of_parts(Shape::Kind::difference, {square, hole}), 2, 4.0 - pi * 0.25},
      {of_parts(Shape::Kind::join, {square, box({0, 0, 0}, {2, 2, 0})}), 2, 7.0},
  };
  for (const Sized& entry : table) {
    const int kind = static_cast<int>(entry.shape.kind);
    EXPECT_NEAR(volume_estimate(entry.shape, entry.dimension), entry.volume, 0.01 * entry.volume)
        << kind;
    EXPECT_NEAR(sampled_volume(entry.shape, entry.dimension), entry.volume, 0.02 * entry.volume)
        << kind;
  }
}

TEST(Shapes, ClosedFormsAreExact) {
  EXPECT_NEAR(volume_estimate(round(Shape::Kind::ring, 2.0, 1.5), 2), pi * 1.75, 1e-14 * pi);
  EXPECT_NEAR(volume_estimate(polygon({{0, 0}, {4, 0}, {0, 3}}), 2), 6.0, 1e-14);
}

TEST(Shapes, BoundaryPointsAreInside) {
  const Shape triangle = polygon({{0, 0}, {0.3, 0}, {0, 0.3}});
  for (int i = 0; i <= 30; ++i)
    EXPECT_TRUE(contains(triangle, {i * 0.01, 0.3 - i * 0.01, 0.0}, 2)) << i;
  Shape disc = round(Shape::Kind::disc, 0.05);
  disc.centre = {};
  for (const Point& point :
       {Point{0.03, 0.04, 0}, {-0.03, 0.04, 0}, {0.04, -0.03, 0}, {0, 0.05, 0}})
    EXPECT_TRUE(contains(disc, point, 2));
  EXPECT_FALSE(contains(disc, {0.0301, 0.04, 0.0}, 2));
}

TEST(Shapes, BoxOfATiltedCylinderIsTight) {
  const Shape cylinder = round(Shape::Kind::disc, 0.5, 0.0, 3.0);
  const Box around = bounding_box(cylinder, 3);
  // An end disc of radius r with axis n extends r sqrt(1 - n_a^2) along coordinate a.
  EXPECT_NEAR(around.minimum[0], 0.3 - 0.5 * std::sqrt(8.0 / 9.0), 1e-14);
  EXPECT_NEAR(around.maximum[1], -0.2 + 2.0 + 0.5 * std::sqrt(5.0 / 9.0), 1e-14);
}

}  // namespace
}  // namespace kerf
