// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/fill.hpp"
#include "geometry/point_vectors.hpp"
#include "geometry/shapes.hpp"
#include "model/body.hpp"
#include "support/kernel_sum.hpp"
#include "support/shapes.hpp"

namespace kerf {
namespace {

constexpr double wall_spacing = 1e-3;
constexpr double layers_depth = 2.6e-3;

Body rigid(const Shape& shape) {
  Body body;
  body.role = Role::rigid;
  body.shape = shape;
  body.spacing = wall_spacing;
  return body;
}

// A rectangle of these edges, turned by `angle` and moved.
Shape turned_plate(double length, double thickness, double angle, const Point& middle = {}) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  shape.depth_maximum = 12e-3;
  const double c = std::cos(angle), s = std::sin(angle);
  for (const auto& v : {std::array{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    const double x = v[0] * length, y = v[1] * thickness;
    shape.vertices.push_back({middle[0] + c * x - s * y, middle[1] + s * x + c * y});
  }
  return shape;
}

struct Layout {
  std::vector<Point> points;
  std::vector<std::optional<NearestFace>> faces;
};

Layout lay(const Body& body, int dimension, std::vector<Shape> others = {}) {
  Layout layout;
  layout.points = fill(body, dimension);
  layout.faces =
      lay_along_surface({body, std::move(others), layers_depth}, dimension, layout.points);
  return layout;
}

// Half a spacing above a plane face, as far as the row of water at rest, the wall fills the same
// share of the kernel as the layers of a lattice in line with the face, at any angle, place along
// the face and place of the lattice.
TEST(SurfaceLayers, AnInclinedPlateFillsTheKernelAsOneInLineWithItsLattice) {
  const Body straight = rigid(turned_plate(60e-3, 6e-3, 0.0));
  const Layout aligned{fill(straight, 2), {}};
  double expected = 0.0;
  for (int k = 0; k < 20; ++k)
    expected += test::kernel_sum(straight, aligned.points, {0.05e-3 * k, 3.5e-3, 0.0}, 2) / 20.0;
  for (const double degrees : {0.0, 3.0, 17.0, 30.0, 45.0, 58.0, 90.0, 151.0})
    for (const double shift : {0.0, 0.3e-3}) {
      const double angle = degrees / 180.0 * std::numbers::pi;
      const Body body = rigid(turned_plate(60e-3, 6e-3, angle, {shift, 0.7 * shift, 0.0}));
      const Layout layout = lay(body, 2);
      double least = 1.0, most = 0.0;
      for (double along = -20e-3; along < 20e-3; along += 0.1e-3) {
        const Point x{shift + along * std::cos(angle) - 3.5e-3 * std::sin(angle),
                      0.7 * shift + along * std::sin(angle) + 3.5e-3 * std::cos(angle), 0.0};
        const double sum = test::kernel_sum(body, layout.points, x, 2);
        least = std::min(least, sum), most = std::max(most, sum);
      }
      EXPECT_GT(least, 0.995 * expected) << degrees;
      EXPECT_LT(most, 1.005 * expected) << degrees;
    }
}

// Every particle within reach lies at (l + 1/2) d below its face, and every convex corner has one
// at its bisector: a rectangle holds as many as one in line with its lattice.
TEST(SurfaceLayers, LieAtHalfOddSpacingsBelowTheFace) {
  for (double degrees = 0.0; degrees < 360.0; degrees += 1.7) {
    const double angle = degrees / 180.0 * std::numbers::pi;
    const Body body = rigid(turned_plate(20e-3, 6e-3, angle, {0.2e-3, 0.1e-3, 0.0}));
    const Layout layout = lay(body, 2);
    EXPECT_EQ(layout.points.size(), 120U) << degrees;
    for (std::size_t i = 0; i < layout.points.size(); ++i) {
      EXPECT_TRUE(contains(body.shape, layout.points[i], 2));
      const auto face = nearest_face(body.shape, {}, layout.points[i], 3e-3, 2);
      ASSERT_TRUE(face && (layout.faces[i] || face->depth > layers_depth)) << degrees;
      const double layer = face->depth / wall_spacing - 0.5;
      EXPECT_NEAR(layer, std::round(layer), 0.02) << degrees;
    }
  }
}

// Layers go round the corner of a vessel, and end where another body covers the surface.
TEST(SurfaceLayers, AVesselInLineWithItsLatticeStaysAsItIs) {
  const Body body = rigid(
      test::of_parts(Shape::Kind::difference, {test::box({-10e-3, -5e-3, 0}, {10e-3, 10e-3, 0}),
                                               test::box({-5e-3, 0, 0}, {5e-3, 12e-3, 0})}));
  EXPECT_EQ(lay(body, 2).points, fill(body, 2));
}

TEST(SurfaceLayers, EndWhereAnotherBodyCoversTheSurface) {
  const double angle = 0.3;
  const Body body = rigid(turned_plate(20e-3, 6e-3, angle));
  const double c = std::cos(angle), s = std::sin(angle);
  const Shape beside = turned_plate(20e-3, 6e-3, angle, {20e-3 * c, 20e-3 * s, 0.0});
  const Layout layout = lay(body, 2, {beside});
  double last = -1.0;  // along the plate, in its outermost layer
  for (const Point& x : layout.points)
    if (std::abs(-s * x[0] + c * x[1] - 2.5e-3) < 1e-5) last = std::max(last, c * x[0] + s * x[1]);
  EXPECT_NEAR(last, 10e-3 - 0.5 * wall_spacing, 0.1 * wall_spacing);
}

// A box in line with its lattice is at such depths already.
// The middle of a wall of an odd number of spacings is equally far from both faces: its layer ends.
TEST(SurfaceLayers, FillAWallOfAnOddNumberOfSpacingsAtAnyAngle) {
  for (int step = 0; step < 24; ++step) {
    const double length = 40e-3, thickness = 5e-3;
    const Body wall = rigid(turned_plate(length, thickness, step * std::numbers::pi / 12.0));
    const Layout layout = lay(wall, 2);
    const double cells = length * thickness / (wall_spacing * wall_spacing);
    EXPECT_NEAR(double(layout.points.size()), cells, 0.03 * cells) << step;
    for (std::size_t i = 0; i < layout.points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GT(plane_distance(layout.points[i], layout.points[j]), 0.6 * wall_spacing);
  }
}

TEST(SurfaceLayers, LeaveABoxInLineWithItsLatticeAsItIs) {
  const Body body = rigid(test::box({0, 0, 0}, {20e-3, 10e-3, 7e-3}));
  for (const int dimension : {2, 3}) EXPECT_EQ(lay(body, dimension).points, fill(body, dimension));
}

// Round the inside and the outside of a ring the particles of each layer are as many as fit into
// its area, and stand apart.
TEST(SurfaceLayers, FollowRoundFaces) {
  Shape ring;
  ring.kind = Shape::Kind::ring;
  ring.radius = 20e-3;
  ring.inner_radius = 12e-3;
  const Body body = rigid(ring);
  const Layout layout = lay(body, 2);
  for (const double radius : {12.5e-3, 13.5e-3, 18.5e-3, 19.5e-3}) {
    std::vector<double> angles;
    for (const Point& x : layout.points)
      if (std::abs(std::hypot(x[0], x[1]) - radius) < 0.02e-3)
        angles.push_back(std::atan2(x[1], x[0]));
    std::sort(angles.begin(), angles.end());
    angles.push_back(angles.front() + 2.0 * std::numbers::pi);
    double least = 1.0, most = 0.0;
    for (std::size_t k = 1; k < angles.size(); ++k) {
      const double apart = radius * (angles[k] - angles[k - 1]);
      least = std::min(least, apart), most = std::max(most, apart);
    }
    EXPECT_NEAR(static_cast<double>(angles.size() - 1),
                2.0 * std::numbers::pi * radius / wall_spacing, 1.0);
    EXPECT_GT(least, 0.98 * wall_spacing);
    EXPECT_LT(most, 1.02 * wall_spacing);
  }
}

}  // namespace
}  // namespace kerf
