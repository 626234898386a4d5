// SPDX-License-Identifier: Apache-2.0
// Surfaces that symmetry planes cut, against the divergence theorem: the area vectors of what is
// left of a closed surface add up to the areas of its sections with the planes, along their
// outward normals and with the opposite sign. Areas are closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "geometry/closed_surface.hpp"
#include "geometry/surface_elements.hpp"
#include "support/shapes.hpp"
#include "support/triangle_meshes.hpp"

namespace kerf::test::surface_symmetry_test {
namespace {

constexpr double half_circle = std::numbers::pi;
constexpr double size = 0.02;                     // m, of elements
constexpr double whole = 10.0;                    // m, beyond all shapes
constexpr double rounding = 1e-7;                 // of places of cuts, 1e-9 of elements
constexpr Point centre{0.0131, -0.0052, 0.0073};  // m, off all edges of elements

struct Totals {
  double area = 0.0;
  Point vector{};
};
Totals totals(const std::vector<SurfaceElement>& elements) {
  Totals result;
  for (const SurfaceElement& element : elements) {
    result.area += element.area;
    for (std::size_t a = 0; a < 3; ++a) result.vector[a] += element.area * element.normal[a];
  }
  return result;
}

// Planes at the lower faces of a domain.
SymmetryPlanes above(const Point& minimum, std::array<bool, 3> planes) {
  return {{planes, {}}, {minimum, {whole, whole, whole}}};
}
SymmetryPlanes above(std::size_t axis, double place) {
  Point minimum{-whole, -whole, -whole};
  std::array<bool, 3> planes{};
  minimum[axis] = place;
  planes[axis] = true;
  return above(minimum, planes);
}

Shape sphere(double radius) {
  Shape shape;
  shape.kind = Shape::Kind::sphere;
  shape.centre = centre;
  shape.radius = radius;
  return shape;
}
Shape round(Shape::Kind kind, const Point& axis, double inner = 0.0) {
  Shape shape = sphere(0.3);
  shape.kind = kind;
  shape.axis = axis;
  shape.inner_radius = inner;
  shape.length = 0.2;
  return shape;
}
Shape of_mesh(const TriangleMesh& mesh) {
  Shape shape;
  shape.kind = Shape::Kind::mesh;
  shape.mesh.surface = std::make_shared<const ClosedSurface>(mesh);
  return shape;
}

// Sums over curved patches are accurate to the square of their angle.
TEST(SurfaceAtSymmetry, AnOctantOfASphereHasTheSameAreaVectorAlongAllAxes) {
  for (const double radius : {0.3, 0.31, 0.3274}) {
    const Totals octant =
        totals(surface_elements(sphere(radius), 3, size, above(centre, {true, true, true})));
    const double section = half_circle * radius * radius / 4.0;
    const double curvature = std::pow(size / radius, 2);
    EXPECT_NEAR(octant.area, 2.0 * section, 1e-4 * section) << radius;
    for (const double component : octant.vector)
      EXPECT_NEAR(component, section, 0.2 * curvature * section) << radius;
    EXPECT_NEAR(octant.vector[0], octant.vector[1], 0.01 * curvature * section) << radius;
  }
}

TEST(SurfaceAtSymmetry, ThePlaneNeedNotGoThroughTheCentre) {
  const double radius = 0.3;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double offset : {-0.27, -0.1234, 0.0, 0.071, 0.2}) {
      const SymmetryPlanes planes = above(axis, centre[axis] + offset);
      const Totals rest = totals(surface_elements(sphere(radius), 3, size, planes));
      const double area = 2.0 * half_circle * radius * (radius - offset);
      const double section = half_circle * (radius * radius - offset * offset);
      const double curvature = std::pow(size / radius, 2);
      // A cut is straight in the parameters of a patch, which is accurate to a third of the share
      // size / radius of the patch: all patches of a cut have 2 pi radius size / 2 at most.
      EXPECT_NEAR(rest.area, area, half_circle * size * size / 3.0) << axis << ' ' << offset;
      for (std::size_t a = 0; a < 3; ++a)
        EXPECT_NEAR(rest.vector[a], a == axis ? section : 0.0, 0.2 * curvature * area)
            << axis << ' ' << offset;
    }
}

// What is left of both sides of a plane is the whole surface.
TEST(SurfaceAtSymmetry, BothSidesAddUpToTheWhole) {
  const Shape block = box({-0.1, -0.1, -0.1}, {0.2, 0.5, 0.1});
  const Shape turned = round(Shape::Kind::ring, {0.48, 0.6, 0.64}, 0.1);
  for (const Shape& shape :
       {block, turned, of_parts(Shape::Kind::difference, {sphere(0.4), sphere(0.2)}),
        of_mesh(sphere_mesh(0.3, 3))})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const SymmetryPlanes upper = above(axis, 0.0371);
      SymmetryPlanes lower = upper;
      std::swap(lower.planes.minimum, lower.planes.maximum);
      std::swap(lower.domain.minimum, lower.domain.maximum);
      for (double& place : lower.domain.minimum) place = -whole;
      const double all = totals(surface_elements(shape, 3, size)).area;
      const double sum = totals(surface_elements(shape, 3, size, upper)).area +
                         totals(surface_elements(shape, 3, size, lower)).area;
      EXPECT_NEAR(sum, all, rounding * all) << axis;
    }
}

TEST(SurfaceAtSymmetry, HalfATubeHasNoAreaVectorAlongItsPlane) {
  for (const double step : {0.02, 0.0193, 0.0137})
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Shape tube = round(Shape::Kind::ring, {0.0, 0.0, 1.0}, 0.15);
      tube.kind = Shape::Kind::disc;  // the outer circle alone
      const Totals half = totals(surface_elements(tube, 2, step, above(axis, centre[axis])));
      EXPECT_NEAR(half.area, half_circle * 0.3, rounding) << step;
      EXPECT_NEAR(half.vector[1 - axis], 0.0, step * std::pow(step / 0.3, 2) / 24.0) << step;
      EXPECT_NEAR(half.vector[axis], 0.6, 0.6 * std::pow(step / 0.3, 2) / 10.0) << step;
    }
}

// A plane along the axis of a cylinder that lies at an angle to the others.
TEST(SurfaceAtSymmetry, CutsATurnedCylinder) {
  const Shape cylinder = round(Shape::Kind::disc, {0.6, 0.0, 0.8});
  const Totals half = totals(surface_elements(cylinder, 3, size, above(1, centre[1])));
  const double lateral = half_circle * 0.3 * 0.2, ends = half_circle * 0.09;
  EXPECT_NEAR(half.area, lateral + ends, 1e-5);
  EXPECT_NEAR(half.vector[0], 0.0, 1e-5);
  EXPECT_NEAR(half.vector[1], 0.6 * 0.2, 1e-4);
  EXPECT_NEAR(half.vector[2], 0.0, 1e-5);
}

TEST(SurfaceAtSymmetry, CutsPlaneFacesExactly) {
  const Shape cube = of_mesh(cube_mesh(0.3));
  for (const Shape& shape : {box({0.0, 0.0, 0.0}, {0.3, 0.3, 0.3}), cube}) {
    const Totals rest = totals(
        surface_elements(shape, 3, size, above({0.1137, 0.2071, -whole}, {true, true, false})));
    const double x = 0.3 - 0.1137, y = 0.3 - 0.2071;
    EXPECT_NEAR(rest.area, 2.0 * x * y + 0.3 * (x + y), rounding);
    EXPECT_NEAR(rest.vector[0], 0.3 * y, rounding);
    EXPECT_NEAR(rest.vector[1], 0.3 * x, rounding);
    EXPECT_NEAR(rest.vector[2], 0.0, rounding);
  }
}

TEST(SurfaceAtSymmetry, CutsAMeshOfASphereAlikeAlongAllAxes) {
  const Totals octant = totals(surface_elements(of_mesh(sphere_mesh(0.3, 3)), 3, size,
                                                above({0.0, 0.0, 0.0}, {true, true, true})));
  const Totals beyond = totals(surface_elements(
      of_mesh(sphere_mesh(0.3, 3)), 3, size, above({0.0131, 0.0131, 0.0131}, {true, true, true})));
  for (const Totals& part : {octant, beyond})
    for (const double component : part.vector)
      EXPECT_NEAR(component, part.vector[0], rounding * part.vector[0]);
}

// A face in the plane is no surface; a face that ends there is one to its end.
TEST(SurfaceAtSymmetry, LeavesOutFacesInThePlane) {
  const Totals rest = totals(surface_elements(box({0.0, 0.0, 0.0}, {0.3, 0.2, 0.1}), 3, size,
                                              above({0.0, 0.0, 0.0}, {true, true, true})));
  EXPECT_NEAR(rest.vector[0], 0.2 * 0.1, rounding);
  EXPECT_NEAR(rest.vector[1], 0.3 * 0.1, rounding);
  EXPECT_NEAR(rest.vector[2], 0.3 * 0.2, rounding);
  EXPECT_NEAR(rest.area, 0.2 * 0.1 + 0.3 * 0.1 + 0.3 * 0.2, rounding);
}

}  // namespace
}  // namespace kerf::test::surface_symmetry_test
