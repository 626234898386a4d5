// SPDX-License-Identifier: Apache-2.0
// Surface elements against the areas of surfaces, and against two theorems of closed surfaces: the
// area vectors add up to zero, and their flux of x is the dimension times the volume.
#include "geometry/surface_elements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/shapes.hpp"
#include "support/shapes.hpp"

namespace kerf::test::surface_elements_test {
namespace {

constexpr double half_circle = std::numbers::pi;

Shape round(Shape::Kind kind, double radius, double inner = 0.0) {
  Shape shape;
  shape.kind = kind;
  shape.centre = {0.3, -0.2, 0.1};
  shape.axis = {0.6, 0.0, 0.8};
  shape.radius = radius;
  shape.inner_radius = inner;
  shape.length = 0.7;
  return shape;
}
Shape triangle() {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  shape.vertices = {{0.0, 0.0}, {0.4, 0.0}, {0.0, 0.3}};
  shape.depth_maximum = 0.2;
  return shape;
}
void expect_surface(const Shape& shape, int dimension, double area, double volume,
                    double tolerance) {
  double sum = 0.0, flux = 0.0;
  Point total{};
  for (const SurfaceElement& element : surface_elements(shape, dimension, 0.01)) {
    sum += element.area;
    for (std::size_t a = 0; a < 3; ++a) {
      total[a] += element.area * element.normal[a];
      flux += element.area * element.normal[a] * element.position[a];
    }
  }
  EXPECT_NEAR(sum, area, tolerance * area);
  EXPECT_NEAR(flux, dimension * volume, (tolerance + 1e-3) * dimension * volume);
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(total[a], 0.0, tolerance * area);
}

TEST(SurfaceElements, OfPlaneShapes) {
  expect_surface(box({0.0, 0.0, 0.0}, {0.3, 0.2, 0.0}), 2, 1.0, 0.06, 1e-12);
  expect_surface(round(Shape::Kind::disc, 0.5), 2, half_circle, half_circle / 4.0, 1e-12);
  expect_surface(round(Shape::Kind::ring, 0.5, 0.3), 2, 1.6 * half_circle, 0.16 * half_circle,
                 1e-12);
  expect_surface(triangle(), 2, 1.2, 0.06, 1e-12);
}

TEST(SurfaceElements, OfSolidShapes) {
  expect_surface(box({0.0, 0.0, 0.0}, {0.3, 0.2, 0.1}), 3, 0.22, 0.006, 1e-12);
  expect_surface(round(Shape::Kind::disc, 0.5), 3, half_circle * (0.7 + 0.5), 0.175 * half_circle,
                 1e-12);
  expect_surface(round(Shape::Kind::ring, 0.5, 0.3), 3, half_circle * (1.6 * 0.7 + 0.32),
                 0.112 * half_circle, 1e-12);
  expect_surface(round(Shape::Kind::sphere, 0.5), 3, half_circle, half_circle / 6.0, 1e-12);
  expect_surface(triangle(), 3, 1.2 * 0.2 + 0.12, 0.012, 1e-3);
}

// A hole in a block, two blocks that overlap with faces in one plane, and a corner cut away.
TEST(SurfaceElements, OfUnionsAndDifferences) {
  Shape hole = round(Shape::Kind::disc, 0.05);
  hole.centre = {0.15, 0.1, 0.0};
  const Shape block = box({0.0, 0.0, 0.0}, {0.3, 0.2, 0.0});
  expect_surface(of_parts(Shape::Kind::difference, {block, hole}), 2, 1.0 + 0.1 * half_circle,
                 0.06 - 0.0025 * half_circle, 1e-12);
  const Shape beside = box({0.2, 0.0, 0.0}, {0.5, 0.2, 0.0});
  // Edges that end within a face: to half of an element of 0.01 at each of the two ends.
  expect_surface(of_parts(Shape::Kind::join, {block, beside}), 2, 1.4, 0.1, 0.01 / 1.4);
  const Shape corner = box({0.2, 0.1, 0.0}, {0.5, 0.4, 0.0});
  expect_surface(of_parts(Shape::Kind::difference, {block, corner}), 2, 1.0, 0.05, 1e-12);
}

TEST(SurfaceElements, WithinARegion) {
  double area = 0.0;
  const Shape block = box({0.0, 0.0, 0.0}, {0.3, 0.2, 0.0});
  const Shape right = box({0.29, -1.0, 0.0}, {0.31, 1.0, 0.0});
  for (const SurfaceElement& element : surface_elements_within(right, block, 2, 0.005)) {
    area += element.area;
    EXPECT_GT(element.position[0], 0.289);
  }
  EXPECT_NEAR(area, 0.2 + 2 * 0.01, 1e-12);  // the end, and 10 mm of both sides
}

}  // namespace
}  // namespace kerf::test::surface_elements_test
