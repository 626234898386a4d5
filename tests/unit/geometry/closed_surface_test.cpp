// SPDX-License-Identifier: Apache-2.0
// The interior of a surface of triangles against closed forms.
#include "geometry/closed_surface.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "support/triangle_meshes.hpp"

namespace kerf::test {
namespace {

constexpr double pi = std::numbers::pi;

// Returns the mesh as read from a file: shared corners are merged, coordinates have seven digits.
TriangleMesh as_read(const TriangleMesh& mesh) {
  TriangleMesh read = read_triangles(stl_binary(mesh), "stl");
  EXPECT_EQ(find_opening(read), "");
  return read;
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b, bool turned) {
  const auto first = static_cast<std::uint32_t>(a.corners.size());
  a.corners.insert(a.corners.end(), b.corners.begin(), b.corners.end());
  for (auto [i, j, k] : b.triangles) {
    if (turned) std::swap(i, j);
    a.triangles.push_back({first + i, first + j, first + k});
  }
  return a;
}

TEST(ClosedSurface, ContainsThePointsOfACube) {
  const ClosedSurface cube(as_read(cube_mesh(2.0, {-1.0, -1.0, -1.0})));
  EXPECT_NEAR(cube.volume(), 8.0, 1e-14);
  // The points are on a grid that includes the centre, faces, edges, corners and both diagonals of
  // every face.
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j)
      for (int k = -6; k <= 6; ++k) {
        const bool inside = std::max({std::abs(i), std::abs(j), std::abs(k)}) <= 4;
        EXPECT_EQ(cube.contains({0.25 * i, 0.25 * j, 0.25 * k}), inside)
            << i << ' ' << j << ' ' << k;
      }
  // The tolerance is 1e-6 of the edge: 2e-6.
  EXPECT_TRUE(cube.contains({0.3, 0.1, 1.0 + 1.5e-6}));
  EXPECT_FALSE(cube.contains({0.3, 0.1, 1.0 + 3e-6}));
}

// An octahedron with rays along z through its two corners, its edges and its centre.
TEST(ClosedSurface, RaysThroughCornersAndEdgesAreCountedOnce) {
  const ClosedSurface surface(as_read(sphere_mesh(1.0, 0)));
  EXPECT_NEAR(surface.volume(), 4.0 / 3.0, 1e-14);
  for (int i = -8; i <= 8; ++i)
    for (int j = -8; j <= 8; ++j)
      for (int k = -8; k <= 8; ++k) {
        const bool inside = std::abs(i) + std::abs(j) + std::abs(k) <= 6;
        EXPECT_EQ(surface.contains({i / 6.0, j / 6.0, k / 6.0}), inside)
            << i << ' ' << j << ' ' << k;
      }
}

// The polyhedron is inside the sphere, within the height of its flattest cap.
TEST(ClosedSurface, ASphereConvergesWithItsTriangles) {
  double before = 0.0;
  for (int splits = 2; splits <= 5; ++splits) {
    const ClosedSurface sphere(as_read(sphere_mesh(3.0, splits)));
    const double lack = 36.0 * pi - sphere.volume();
    EXPECT_GT(lack, 0.0);
    // The error is of second order in the edges, which are halved: a quarter.
    if (before > 0.0) {
      EXPECT_NEAR(lack / before, 0.25, 0.02);
    }
    before = lack;
  }
  EXPECT_LT(before, 2e-3 * 36.0 * pi);
}

TEST(ClosedSurface, ContainsThePointsOfATorus) {
  const std::uint32_t sides = 96;
  const ClosedSurface torus(as_read(torus_mesh(3.0, 1.0, sides)));
  // The deficit of a polygon of n sides to the exact 6 pi^2 is less than (2 pi / n)^2 / 6 for
  // either circle.
  EXPECT_NEAR(torus.volume(), 6.0 * pi * pi, 2.0 * std::pow(2.0 * pi / sides, 2) / 6.0 * 60.0);
  // Chords are up to (pi / n)^2 / 2 of a radius inside their circles, the larger of which is 4.
  const double band = 4.0 * std::pow(pi / sides, 2);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-4.2, 4.2);
  for (int n = 0; n < 50000; ++n) {
    const Point x{uniform(random), uniform(random), uniform(random) / 3.0};
    const double distance = std::hypot(std::hypot(x[0], x[1]) - 3.0, x[2]) - 1.0;
    if (std::abs(distance) <= band) continue;
    EXPECT_EQ(torus.contains(x), distance < 0.0) << distance;
  }
}

TEST(ClosedSurface, ShellsThatFaceInwardsAreVoids) {
  const TriangleMesh outer = cube_mesh(3.0), inner = cube_mesh(1.0, {1.0, 1.0, 1.0});
  const ClosedSurface hollow(joined(outer, inner, true)), both(joined(outer, inner, false));
  EXPECT_NEAR(hollow.volume(), 26.0, 1e-13);
  EXPECT_FALSE(hollow.contains({1.5, 1.5, 1.5}));
  EXPECT_TRUE(hollow.contains({0.5, 1.5, 1.5}));
  EXPECT_TRUE(both.contains({1.5, 1.5, 1.5}));
}

TEST(ClosedSurface, ShellsThatOverlapAreOneRegion) {
  const ClosedSurface overlap(joined(cube_mesh(2.0), cube_mesh(2.0, {1.0, 1.0, 1.0}), false));
  EXPECT_TRUE(overlap.contains({1.5, 1.5, 1.5}));
  EXPECT_TRUE(overlap.contains({2.5, 2.5, 2.5}));
  EXPECT_FALSE(overlap.contains({2.5, 0.5, 0.5}));
}

TEST(ClosedSurface, ASurfaceInsideOutIsTheSameRegion) {
  TriangleMesh mesh = cube_mesh(1.0);
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(find_opening(mesh), "");
  const ClosedSurface cube(mesh);
  EXPECT_NEAR(cube.volume(), 1.0, 1e-15);
  EXPECT_TRUE(cube.contains({0.5, 0.5, 0.5}));
}

// The box is rotated about x, then y, then z: the image of its corner (1, 2, 3) is computed by
// hand.
TEST(ClosedSurface, PlacesAScaledAndRotatedPart) {
  MeshShape shape;
  shape.scale = 2.0;
  shape.rotation = {0.5 * pi, 0.5 * pi, 0.0};
  shape.position = {10.0, 20.0, 30.0};
  TriangleMesh mesh;
  mesh.corners = {{1.0, 2.0, 3.0}};
  // About x: (1, -3, 2); about y: (2, -3, -1).
  place_mesh(mesh, shape);
  EXPECT_EQ(mesh.corners[0], (Point{14.0, 14.0, 28.0}));
}

// The interior does not change when surface and point are rotated together.
TEST(ClosedSurface, RotationKeepsTheInteriorPoints) {
  MeshShape shape;
  shape.scale = 1e-3;
  shape.rotation = {0.3, -0.7, 1.1};
  shape.position = {0.02, -0.01, 0.03};
  TriangleMesh mesh = torus_mesh(3.0, 1.0, 24), turned = mesh;
  place_mesh(turned, shape);
  const ClosedSurface before(mesh), after(turned);
  EXPECT_NEAR(after.volume() / before.volume(), 1e-9, 1e-21);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-4.0, 4.0);
  TriangleMesh points;
  for (int n = 0; n < 20000; ++n)
    points.corners.push_back({uniform(random), uniform(random), uniform(random) / 4.0});
  const auto original = points.corners;
  place_mesh(points, shape);
  int inside = 0, different = 0;
  for (std::size_t n = 0; n < original.size(); ++n) {
    inside += before.contains(original[n]);
    different += before.contains(original[n]) != after.contains(points.corners[n]);
  }
  EXPECT_GT(inside, 5000);
  EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace kerf::test
