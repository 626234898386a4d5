// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "geometry/fill.hpp"
#include "geometry/nearest_face.hpp"
#include "geometry/shapes.hpp"
#include "model/body.hpp"
#include "support/kernel_sum.hpp"
#include "support/shapes.hpp"

namespace kerf {
namespace {

constexpr double fit_spacing = 1e-3;

Body fitted(const Shape& shape) {
  Body body;
  body.shape = shape;
  body.spacing = fit_spacing;
  body.body_fitted = true;
  return body;
}
std::vector<Point> on_lattice(Body body, int dimension) {
  body.body_fitted = false;
  return fill(body, dimension);
}

// `radius` and `inner_radius` in spacings.
Shape round_region(Shape::Kind kind, double radius, double inner_radius = 0.0) {
  Shape shape;
  shape.kind = kind;
  shape.centre = {0.31e-3, -0.12e-3, 0.05e-3};
  shape.radius = radius * fit_spacing;
  shape.inner_radius = inner_radius * fit_spacing;
  shape.length = radius * fit_spacing;
  return shape;
}
Shape tilted_cylinder(double radius, double angle) {
  Shape shape = round_region(Shape::Kind::disc, radius);
  shape.axis = {0.0, std::cos(angle), std::sin(angle)};
  return shape;
}
// A rectangle of 40 x `thickness` spacings, turned.
Shape turned_slab(double thickness, double angle) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  const double c = std::cos(angle), s = std::sin(angle);
  for (const auto& v : {std::array{0.0, 0.0}, {40.0, 0.0}, {40.0, thickness}, {0.0, thickness}})
    shape.vertices.push_back(
        {fit_spacing * (c * v[0] - s * v[1]), fit_spacing * (s * v[0] + c * v[1])});
  return shape;
}

struct Depths {
  double least = 1e300;    // spacings
  double mean = 0.0;       // of those less than 0.8 deep
  double deviation = 0.0;  // rms from 0.5 of these
  std::size_t outermost = 0;
};

Depths depths_of(const Body& body, const std::vector<Point>& points, int dimension) {
  Depths result;
  for (const Point& point : points) {
    EXPECT_TRUE(contains(body.shape, point, dimension));
    const auto face = nearest_face(body.shape, {}, point, fit_spacing, dimension);
    if (!face) continue;
    const double depth = face->depth / fit_spacing;
    result.least = std::min(result.least, depth);
    if (depth > 0.8) continue;
    ++result.outermost;
    result.mean += depth;
    result.deviation += (depth - 0.5) * (depth - 0.5);
  }
  result.mean /= static_cast<double>(result.outermost);
  result.deviation = std::sqrt(result.deviation / static_cast<double>(result.outermost));
  return result;
}

// sum V W at the points, over that of the lattice: least and greatest, deeper than two spacings
// and a half; and the least distance of two points, in spacings.
struct Filling {
  double least = 1e300, most = 0.0, closest = 1e300;
};
Filling filling_of(const Body& body, const std::vector<Point>& points, int dimension) {
  const double lattice = dimension == 2 ? 1.0105 : 1.0095;
  Filling result;
  for (const Point& x : points) {
    for (const Point& y : points) {
      const double r = std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
      if (r > 0.0) result.closest = std::min(result.closest, r / fit_spacing);
    }
    if (nearest_face(body.shape, {}, x, 2.5 * fit_spacing, dimension)) continue;
    const double sum = test::kernel_sum(body, points, x, dimension);
    result.least = std::min(result.least, sum / lattice);
    result.most = std::max(result.most, sum / lattice);
  }
  return result;
}

void lies_along_its_surface(const char* name, const Shape& shape, int dimension) {
  const Body body = fitted(shape);
  const auto nodes = on_lattice(body, dimension), points = fill(body, dimension);
  ASSERT_EQ(points.size(), nodes.size());
  const Depths before = depths_of(body, nodes, dimension);
  const Depths after = depths_of(body, points, dimension);
  std::printf("%s: depth %.3f, off by %.3f, at least %.3f (lattice: %.3f, %.3f, %.3f)\n", name,
              after.mean, after.deviation, after.least, before.mean, before.deviation,
              before.least);
  EXPECT_GT(before.deviation, 0.15) << "the lattice must be a staircase for this test to say more";
  EXPECT_NEAR(after.mean, 0.5, 0.01);
  EXPECT_LT(after.deviation, 0.02);
  EXPECT_GT(after.least, 0.45);
  EXPECT_GE(after.outermost, 0.9 * static_cast<double>(before.outermost));
}

TEST(SurfaceFit, TheOutermostParticlesLieHalfASpacingDeep) {
  for (const double radius : {7.3, 12.0, 20.0, 33.7})
    lies_along_its_surface("disc", round_region(Shape::Kind::disc, radius), 2);
  lies_along_its_surface("ring", round_region(Shape::Kind::ring, 20.0, 14.2), 2);
  for (const double angle : {5.0, 20.0, 33.0, 45.0, 71.0, -12.0})
    lies_along_its_surface("slab", turned_slab(11.3, angle * std::numbers::pi / 180.0), 2);
}

TEST(SurfaceFit, TheOutermostParticlesLieHalfASpacingDeepIn3D) {
  lies_along_its_surface("sphere", round_region(Shape::Kind::sphere, 9.0), 3);
  lies_along_its_surface("tilted cylinder", tilted_cylinder(9.0, 0.6), 3);
}

TEST(SurfaceFit, ParticlesFillTheShapeEvenly) {
  const auto check = [](const char* name, const Shape& shape, int dimension) {
    const Body body = fitted(shape);
    const auto points = fill(body, dimension);
    // A lattice has more or fewer nodes in a shape than volumes.
    const double mean = static_cast<double>(points.size()) * particle_volume(body, dimension) /
                        volume_estimate(shape, dimension);
    const Filling filling = filling_of(body, points, dimension);
    std::printf("%s: sum V W %.3f to %.3f of a lattice, mean %.3f; closest %.3f spacings\n", name,
                filling.least, filling.most, mean, filling.closest);
    EXPECT_GT(filling.least, mean - 0.03);
    EXPECT_LT(filling.most, mean + 0.04);
    EXPECT_GT(filling.closest, 0.7);
  };
  check("disc", round_region(Shape::Kind::disc, 20.0), 2);
  check("slab at 20 degrees", turned_slab(11.3, 0.35), 2);
  check("slab at 5 degrees", turned_slab(11.3, 0.09), 2);
  check("sphere", round_region(Shape::Kind::sphere, 9.0), 3);
}

TEST(SurfaceFit, WhatIsInLineWithItsLatticeStays) {
  Shape angle;
  angle.kind = Shape::Kind::polygon;
  angle.vertices = {{0, 0}, {0.02, 0}, {0.02, 0.0073}, {0.008, 0.0073}, {0.008, 0.02}, {0, 0.02}};
  for (const Shape& shape : {angle, test::box({0, 0, 0}, {0.0123, 0.02, 0.01})}) {
    EXPECT_FALSE(has_slanted_face(shape, 2));
    const Body body = fitted(shape);
    EXPECT_EQ(fill(body, 2), on_lattice(body, 2));
  }
}

TEST(SurfaceFit, AHoleMovesOnlyWhatIsNear) {
  Shape hole = round_region(Shape::Kind::disc, 4.0);
  hole.centre = {0.0301, 0.0077, 0.0};
  const Body body = fitted(
      test::of_parts(Shape::Kind::difference, {test::box({0, 0, 0}, {0.06, 0.02, 0.0}), hole}));
  const auto nodes = on_lattice(body, 2), points = fill(body, 2);
  ASSERT_EQ(points.size(), nodes.size());
  std::size_t moved = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double off = std::hypot(points[i][0] - nodes[i][0], points[i][1] - nodes[i][1]);
    const double distance =
        std::hypot(nodes[i][0] - hole.centre[0], nodes[i][1] - hole.centre[1]) - hole.radius;
    if (distance > 5.0 * fit_spacing) {
      EXPECT_EQ(off, 0.0) << i;
    }
    if (nodes[i][1] < fit_spacing) {
      EXPECT_EQ(points[i][1], nodes[i][1]) << "the row along the lower face stays in line";
    }
    if (off > 0.0) ++moved;
  }
  EXPECT_GT(moved, 100u);
  EXPECT_GT(depths_of(body, points, 2).least, 0.45);
}

TEST(SurfaceFit, ASymmetricShapeHasASymmetricLayout) {
  Shape disc = round_region(Shape::Kind::disc, 11.4);
  disc.centre = {0.0, 0.0, 0.0};
  const auto points = fill(fitted(disc), 2);
  for (const Point& point : points) {
    double nearest = 1e300;
    for (const Point& other : points)
      nearest = std::min(nearest, std::hypot(point[0] + other[0], point[1] - other[1]));
    EXPECT_LT(nearest, 1e-9 * fit_spacing);
  }
}

}  // namespace
}  // namespace kerf
