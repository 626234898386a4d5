// SPDX-License-Identifier: Apache-2.0
// Which shapes have voids, and whose region a body shares.
#include "geometry/solid_region.hpp"

#include <gtest/gtest.h>

#include "model/case.hpp"
#include "support/shapes.hpp"

namespace kerf::test {
namespace {

Shape polygon(std::vector<std::array<double, 2>> vertices) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  shape.vertices = std::move(vertices);
  return shape;
}

Body body_of(Shape shape) {
  Body body;
  body.role = Role::elastic;
  body.shape = std::move(shape);
  return body;
}

TEST(SolidRegion, TellsConvexShapes) {
  const Shape block = box({0, 0, 0}, {4, 4, 4});
  EXPECT_TRUE(is_convex(block, 3));
  EXPECT_FALSE(is_convex(of_parts(Shape::Kind::difference, {block, box({1, 1, 0}, {2, 2, 4})}), 2));
  EXPECT_FALSE(is_convex(of_parts(Shape::Kind::join, {block, box({5, 0, 0}, {6, 4, 4})}), 2));
  Shape tube;
  tube.kind = Shape::Kind::ring;
  EXPECT_FALSE(is_convex(tube, 2));
  for (const double turn : {1.0, -1.0}) {
    EXPECT_TRUE(is_convex(polygon({{0, 0}, {4, 0}, {5, 3 * turn}, {0, 4 * turn}}), 2));
    EXPECT_TRUE(is_convex(polygon({{0, 0}, {2, 0}, {4, 0}, {2, 4 * turn}}), 2));
    EXPECT_FALSE(is_convex(polygon({{0, 0}, {4, 0}, {1, 1 * turn}, {0, 4 * turn}}), 2));
  }
  // A star that turns to one side only, twice around.
  EXPECT_FALSE(
      is_convex(polygon({{0, 1}, {0.59, -0.81}, {-0.95, 0.31}, {0.95, 0.31}, {-0.59, -0.81}}), 2));
}

TEST(SolidRegion, JoinedBodiesShareTheirs) {
  const Shape block = box({0, 0, 0}, {4, 4, 4}), rod = box({1, 1, 0}, {2, 2, 4});
  const std::vector<Body> bodies{body_of(of_parts(Shape::Kind::difference, {block, rod})),
                                 body_of(rod), body_of(box({9, 0, 0}, {12, 4, 4}))};
  const auto apart = regions_of(bodies, {0, 1, 2}, 3);
  ASSERT_TRUE(apart[0]);
  EXPECT_FALSE(is_within(*apart[0], {1.5, 1.5, 1.0}, 3));
  EXPECT_FALSE(apart[1]);
  EXPECT_FALSE(apart[2]);
  const auto joined = regions_of(bodies, {0, 0, 2}, 3);
  EXPECT_TRUE(is_within(*joined[0], {1.5, 1.5, 1.0}, 3));
}

}  // namespace
}  // namespace kerf::test
