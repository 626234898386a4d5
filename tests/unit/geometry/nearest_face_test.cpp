// SPDX-License-Identifier: Apache-2.0
// The nearest face of a shape, by what it is: a ball of its depth about the point touches the
// surface there and nowhere leaves the shape.
#include "geometry/nearest_face.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/shapes.hpp"
#include "support/shapes.hpp"

namespace kerf::test::nearest_face_test {
namespace {

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

// A notched plate, turned about 0.
Shape plate(double angle) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  shape.depth_minimum = -0.3;
  shape.depth_maximum = 0.3;
  const double c = std::cos(angle), s = std::sin(angle);
  for (const auto& v : {std::array{-1.0, -0.5}, std::array{1.0, -0.5}, std::array{1.0, 0.5},
                        std::array{0.6, 0.5}, std::array{0.0, 0.1}, std::array{-1.0, 0.5}})
    shape.vertices.push_back({c * v[0] - s * v[1], s * v[0] + c * v[1]});
  return shape;
}

Point random_direction(std::mt19937_64& random, int dimension) {
  std::normal_distribution<double> normal;
  Point direction{normal(random), normal(random), dimension == 3 ? normal(random) : 0.0};
  double square = 0.0;
  for (const double x : direction) square += x * x;
  for (double& x : direction) x /= std::sqrt(square);
  return direction;
}

Point step(const Point& from, double length, const Point& direction) {
  return {from[0] + length * direction[0], from[1] + length * direction[1],
          from[2] + length * direction[2]};
}

void expect_touching_balls(const Shape& shape, int dimension) {
  std::mt19937_64 random(11);
  const Box around = bounding_box(shape, dimension);
  int inside = 0;
  for (int n = 0; n < 1000; ++n) {
    Point point{};
    for (std::size_t a = 0; a < std::size_t(dimension); ++a)
      point[a] =
          std::uniform_real_distribution<double>(around.minimum[a], around.maximum[a])(random);
    if (!contains(shape, point, dimension)) continue;
    ++inside;
    const auto face = nearest_face(shape, {}, point, 2.0, dimension);
    ASSERT_TRUE(face) << n;
    if (face->depth < 1e-3) continue;  // the ball is smaller than the steps below
    EXPECT_NEAR(std::hypot(face->normal[0], face->normal[1], face->normal[2]), 1.0, 1e-12);
    EXPECT_TRUE(contains(shape, step(point, face->depth - 1e-4, face->normal), dimension));
    EXPECT_FALSE(contains(shape, step(point, face->depth + 1e-4, face->normal), dimension));
    for (int k = 0; k < 50; ++k)
      EXPECT_TRUE(contains(
          shape, step(point, face->depth - 1e-4, random_direction(random, dimension)), dimension));
  }
  EXPECT_GT(inside, 200);
}

TEST(NearestFace, BallsTouchTheSurface2D) {
  expect_touching_balls(box({-1, -0.3, 0}, {1, 0.3, 0}), 2);
  expect_touching_balls(round(Shape::Kind::disc, 0.8), 2);
  expect_touching_balls(round(Shape::Kind::ring, 0.8, 0.3), 2);
  for (const double angle : {0.0, 0.5, 2.0}) expect_touching_balls(plate(angle), 2);
}

TEST(NearestFace, BallsTouchTheSurface3D) {
  expect_touching_balls(box({-1, -0.3, 0}, {1, 0.3, 0.7}), 3);
  expect_touching_balls(round(Shape::Kind::sphere, 0.8), 3);
  expect_touching_balls(round(Shape::Kind::disc, 0.8, 0.0, 0.9), 3);
  expect_touching_balls(round(Shape::Kind::ring, 0.8, 0.3, 0.9), 3);
  expect_touching_balls(plate(0.5), 3);
}

// The wall and the floor of a tank, and a plate with a hole.
TEST(NearestFace, InnerFacesOfPartsAreNone) {
  expect_touching_balls(of_parts(Shape::Kind::join,
                                 {box({-1, -0.4, 0}, {1, 0, 0}), box({-1.4, -0.4, 0}, {-1, 1, 0})}),
                        2);
  expect_touching_balls(of_parts(Shape::Kind::difference,
                                 {box({-1, -0.9, 0}, {1, 0.5, 0}), round(Shape::Kind::disc, 0.4)}),
                        2);
}

TEST(NearestFace, FacesThatAnotherBodyCoversAreNone) {
  const auto floor = box({0, -0.4, 0}, {1, 0, 0}), rest = box({-1, -0.4, 0}, {0, 0, 0});
  const Point point{0.05, -0.1, 0.0};
  EXPECT_NEAR(nearest_face(floor, {}, point, 2.0, 2)->normal[0], -1.0, 1e-12);
  const auto face = nearest_face(floor, {rest}, point, 2.0, 2);
  EXPECT_NEAR(face->normal[1], 1.0, 1e-12);
  EXPECT_NEAR(face->depth, 0.1, 1e-12);
}

TEST(NearestFace, FacesOutOfReachAreNone) {
  EXPECT_FALSE(nearest_face(box({0, 0, 0}, {1, 1, 0}), {}, {0.5, 0.5, 0.0}, 0.4, 2));
}

}  // namespace
}  // namespace kerf::test::nearest_face_test
