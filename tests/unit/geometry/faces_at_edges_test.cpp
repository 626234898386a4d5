// SPDX-License-Identifier: Apache-2.0
#include "geometry/faces_at_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/fill.hpp"
#include "geometry/point_vectors.hpp"
#include "geometry/surface_layers.hpp"
#include "model/body.hpp"
#include "support/shapes.hpp"

namespace kerf::test::faces_at_edges_test {
namespace {

constexpr double spacing = 1e-3;

double length(const Point& a) {
  return std::sqrt(dot(a, a));
}

// The face of the particle of a rigid body that is nearest to a place.
std::optional<NearestFace> face_beside(const Shape& shape, int dimension, const Point& place) {
  Body body;
  body.role = Role::rigid;
  body.shape = shape;
  body.spacing = spacing;
  std::vector<Point> points = fill(body, dimension);
  const auto faces = lay_along_surface({body, {}, 2.6 * spacing}, dimension, points);
  const auto distance = [&](const Point& point) { return length(sum(point, -1.0, place)); };
  const auto nearest =
      std::min_element(points.begin(), points.end(),
                       [&](const Point& a, const Point& b) { return distance(a) < distance(b); });
  return faces[static_cast<std::size_t>(nearest - points.begin())];
}

// The faces n + c and n - c are these two, in any order.
void expect_faces(const NearestFace& face, const Point& one, const Point& other) {
  EXPECT_NEAR(face.depth, 0.5 * spacing, 1e-3 * spacing);
  const Point plus = sum(face.normal, 1.0, face.corner),
              minus = sum(face.normal, -1.0, face.corner);
  const auto unlike = [](const Point& a, const Point& b) { return length(sum(a, -1.0, b)); };
  EXPECT_LT(std::min(std::max(unlike(plus, one), unlike(minus, other)),
                     std::max(unlike(plus, other), unlike(minus, one))),
            1e-6);
}

// Whatever the order of the faces and the angle of the body; at the end of a plate it is the long
// one.
TEST(FacesAtEdges, TheApexOfAWedgeHasBoth) {
  const auto at = [](double angle, double size) {
    return std::array{size * std::sin(angle), -size * std::cos(angle)};
  };
  for (const auto& [left, right] : {std::pair{0.4, 0.4}, {0.5, 0.9}, {0.9, 0.5}, {0.3, 1.1}})
    for (const double turn : {0.0, 0.7, 2.5}) {
      Shape wedge;
      wedge.kind = Shape::Kind::polygon;
      wedge.vertices = {{0.0, 0.0}, at(turn + right, 20e-3), at(turn - left, 20e-3)};
      const double a = turn + right, b = turn - left;
      expect_faces(*face_beside(wedge, 2, {}), {std::cos(a), std::sin(a), 0.0},
                   {-std::cos(b), -std::sin(b), 0.0});
    }
  Shape plate;
  plate.kind = Shape::Kind::polygon;
  const double c = std::cos(0.4), s = std::sin(0.4);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {60e-3, 0.0}, {60e-3, 6e-3}, {0.0, 6e-3}})
    plate.vertices.push_back({c * x - s * y, s * x + c * y});
  const auto end = face_beside(plate, 2, {60e-3 * c, 60e-3 * s, 0.0});
  EXPECT_EQ(end->corner, Point{});
  EXPECT_NEAR(end->normal[0], s, 1e-6);
}

// A block in space, moved by a part of a spacing and farther: a particle at an edge has both faces,
// that at a corner none, and those around a thin plate have its wide face.
TEST(FacesAtEdges, ThoseOfABlockDoNotDependOnItsPlace) {
  for (const double moved : {0.0, 0.3, 7.77, 20.53, -20.53})
    for (std::size_t a = 0; a < 3; ++a) {
      Point origin{};
      origin[a] = moved * spacing;
      const auto place = [&](const Point& at) { return sum(origin, spacing, at); };
      const Shape block = box(place({0, 0, 0}), place({12, 6, 12}));
      expect_faces(*face_beside(block, 3, place({12, 3.5, 12})), {1, 0, 0}, {0, 0, 1});
      expect_faces(*face_beside(block, 3, place({5.5, 6, 0})), {0, 1, 0}, {0, 0, -1});
      EXPECT_FALSE(face_beside(block, 3, place({12, 6, 12}))) << moved;
      const Shape plate = box(place({0, 0, 0}), place({24, 4, 24}));
      for (const Point& beside : {Point{11.5, 4, 24}, Point{24, 4, 24}}) {
        const auto face = face_beside(plate, 3, place(beside));
        ASSERT_TRUE(face) << moved;
        EXPECT_NEAR(face->normal[1], 1.0, 1e-9) << moved;
        EXPECT_EQ(face->corner, Point{});
      }
    }
}

}  // namespace
}  // namespace kerf::test::faces_at_edges_test
