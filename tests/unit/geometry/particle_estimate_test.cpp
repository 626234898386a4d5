// SPDX-License-Identifier: Apache-2.0
// Estimated numbers of particles agree with real layouts, and their cost does not grow with the
// size of the body.
#include "geometry/particle_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "geometry/fill.hpp"
#include "geometry/plane_turn.hpp"
#include "geometry/shapes.hpp"
#include "support/shapes.hpp"

namespace kerf {
namespace {

constexpr double agreement = 0.05;  // of a count above 10^4

Shape round_shape(Shape::Kind kind, double radius, double inner = 0.0) {
  Shape shape;
  shape.kind = kind;
  shape.centre = {0.01, 0.02, -0.01};
  shape.axis = {0.0, 0.6, 0.8};
  shape.radius = radius;
  shape.inner_radius = inner;
  shape.length = 0.05;
  return shape;
}

Shape angle_polygon() {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  shape.vertices = {{0, 0}, {0.1, 0}, {0.1, 0.02}, {0.02, 0.03}, {0.02, 0.1}, {0, 0.1}};
  shape.depth_maximum = 0.0123;
  return shape;
}

Body body_of_shape(const Shape& shape, double spacing) {
  Body body;
  body.name = "body";
  body.shape = shape;
  body.spacing = spacing;
  return body;
}

std::vector<Shape> many_shapes() {
  const Shape block = test::box({-0.05, 0.0, -0.02}, {0.05, 0.06, 0.021});
  const Shape hole = round_shape(Shape::Kind::disc, 0.015);
  return {block,
          test::box({-0.05, 0.0, 0.0}, {0.05, 0.0017, 0.08}),
          round_shape(Shape::Kind::disc, 0.04),
          round_shape(Shape::Kind::ring, 0.04, 0.037),
          round_shape(Shape::Kind::sphere, 0.05),
          angle_polygon(),
          test::of_parts(Shape::Kind::difference, {block, hole}),
          test::of_parts(Shape::Kind::join, {block, round_shape(Shape::Kind::sphere, 0.06)}),
          test::of_parts(Shape::Kind::join, {block, test::box({0.2, 0, 0}, {0.21, 0.09, 0.04})})};
}

// Returns whether the body is large enough to be compared.
bool compare_with_layout(const Body& body, int dimension) {
  const auto real = static_cast<double>(fill(body, dimension).size());
  const ParticleEstimate estimate = estimate_particles(body, dimension, {}, 2e4);
  if (estimate.is_exact || real < 1e4) return false;
  EXPECT_NEAR(estimate.total(), real, agreement * real)
      << "shape " << static_cast<int>(body.shape.kind) << " in " << dimension << "D";
  if (body.shape.kind == Shape::Kind::box && body.lattice == Lattice::square) {
    EXPECT_NEAR(estimate.total(), real, 0.5);
  }
  return true;
}

TEST(ParticleEstimate, AgreesWithTheLayoutsOfManyShapes) {
  int compared = 0;
  for (const Shape& shape : many_shapes())
    for (const Lattice lattice : {Lattice::square, Lattice::hexagonal}) {
      Body plane = body_of_shape(shape, 0.16e-3), solid = body_of_shape(shape, 1.03e-3);
      plane.lattice = solid.lattice = lattice;
      if (shape.kind != Shape::Kind::sphere) compared += compare_with_layout(plane, 2) ? 1 : 0;
      compared += compare_with_layout(solid, 3) ? 1 : 0;
    }
  EXPECT_GE(compared, 24);
}

TEST(ParticleEstimate, FewNodesAreCounted) {
  const Body body = body_of_shape(round_shape(Shape::Kind::disc, 0.04), 1e-3);
  const ParticleEstimate estimate = estimate_particles(body, 2);
  EXPECT_TRUE(estimate.is_exact);
  EXPECT_EQ(estimate.total(), static_cast<double>(fill(body, 2).size()));
}

void expect_same_levels(const Body& body, int dimension) {
  const auto real = count_levels(body, dimension);
  const ParticleEstimate estimate = estimate_particles(body, dimension, {}, 9e4);
  ASSERT_FALSE(estimate.is_exact);
  ASSERT_EQ(estimate.levels.size(), real.size());
  double total = 0.0;
  for (const std::size_t count : real) total += static_cast<double>(count);
  EXPECT_NEAR(estimate.total(), total, agreement * total);
  for (std::size_t level = 0; level < real.size(); ++level)
    EXPECT_NEAR(estimate.levels[level], static_cast<double>(real[level]), agreement * total)
        << "level " << level << " in " << dimension << "D";
}

TEST(ParticleEstimate, AgreesWithGradedLayouts) {
  Grading grading;
  grading.levels = 3;
  grading.width = 8e-3;
  grading.lines = {{{0.012, 0.06, 0.0}, {0.0, -1.0, 0.0}, 1e-3}};
  for (const int dimension : {2, 3})
    for (const Shape& shape : {test::box({-0.05, 0.0, -0.02}, {0.05, 0.06, 0.021}),
                               test::of_parts(Shape::Kind::difference,
                                              {test::box({-0.05, 0.0, -0.02}, {0.05, 0.06, 0.02}),
                                               round_shape(Shape::Kind::disc, 0.012)})}) {
      Body body = body_of_shape(shape, dimension == 2 ? 0.2e-3 : 1e-3);
      body.grading = grading;
      expect_same_levels(body, dimension);
    }
}

// Lattices that follow the faces of a turned body (geometry/lattice_angle.hpp).
TEST(ParticleEstimate, AgreesWithTurnedLattices) {
  constexpr double angle = 0.4;
  const PlaneTurn turn(angle);
  const Shape block = test::box({-0.05, 0.0, -0.02}, {0.05, 0.06, 0.021});
  for (const int dimension : {2, 3}) {
    Body body = body_of_shape(turned(block, turn), dimension == 2 ? 0.16e-3 : 1.03e-3);
    body.lattice_angle = angle;
    EXPECT_TRUE(compare_with_layout(body, dimension));
    body.grading.levels = 2;
    body.grading.width = 8e-3;
    body.grading.lines = {{turn({0.012, 0.06, 0.0}), turn({0.0, -1.0, 0.0}), 1e-3}};
    expect_same_levels(body, dimension);
    const auto fine = particle_at(body, dimension, turn({0.012, 0.03, 0.0}));
    const auto coarse = particle_at(body, dimension, turn({-0.045, 0.03, 0.0}));
    ASSERT_TRUE(fine && coarse);
    EXPECT_EQ(fine->level, 0);
    EXPECT_EQ(coarse->level, 2);
    EXPECT_FALSE(particle_at(body, dimension, turn({0.012, -0.004, 0.0})));
  }
}

// A body that is drawn whole counts for the part on the simulated side of the planes.
TEST(ParticleEstimate, MirrorImagesDoNotCount) {
  CountedSide side;
  side.planes.minimum = {true, false, true};
  side.domain = {{0.0, -1.0, 0.0}, {1.0, 1.0, 1.0}};
  for (const double spacing : {1e-3, 0.1e-3}) {
    const Body body = body_of_shape(test::box({-0.04, 0.0, -0.02}, {0.04, 0.03, 0.02}), spacing);
    const double whole = 0.08 * 0.03 * 0.04 / std::pow(spacing, 3);
    EXPECT_NEAR(estimate_particles(body, 3).total(), whole, 1e-9 * whole);
    EXPECT_NEAR(estimate_particles(body, 3, side).total(), 0.25 * whole, 0.01 * 0.25 * whole);
  }
}

TEST(ParticleEstimate, TakesNoLongerForHugeBodies) {
  for (const double spacing : {1e-4, 1e-6, 1e-9})
    for (const int levels : {0, 5}) {
      Body body = body_of_shape(many_shapes()[6], spacing);
      body.grading.levels = levels;
      body.grading.width = 100.0 * spacing;
      body.grading.lines = {{{0.012, 0.06, 0.0}, {0.0, -1.0, 0.0}, 1e-3}};
      const std::clock_t start = std::clock();  // of the processor: other work does not count
      EXPECT_GT(estimate_particles(body, 3).total(), 1e5);
      EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 2.0)
          << spacing << " m, " << levels << " levels";
    }
}

}  // namespace
}  // namespace kerf
