// SPDX-License-Identifier: Apache-2.0
// Bodies of several spacings fill the same region as uniform ones, and are fine in the right
// region.
#include "geometry/graded_fill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/fill.hpp"

namespace kerf {
namespace {

Body graded_body(const Shape& shape, double spacing, int levels, double width) {
  Body body;
  body.name = "block";
  body.shape = shape;
  body.spacing = spacing;
  body.grading.levels = levels;
  body.grading.width = width;
  return body;
}

Shape box_between(const Point& low, const Point& high) {
  Shape shape;
  shape.box = {low, high};
  return shape;
}

Shape holed_box() {
  Shape hole;
  hole.kind = Shape::Kind::disc;
  hole.centre = {30e-3, 14e-3, 0.0};
  hole.radius = 5e-3;
  hole.length = 1.0;
  Shape shape;
  shape.kind = Shape::Kind::difference;
  shape.parts = {box_between({-50e-3, 0.0, 0.0}, {50e-3, 27e-3, 20e-3}), hole};
  return shape;
}

// Returns the finest cells that a particle covers, as integers.
void cover(const GradedParticle& particle, double spacing, int dimension,
           std::multiset<std::array<long, 3>>& covered) {
  const long across = 1L << particle.level;
  for (long k = 0; k < 1L << (dimension * particle.level); ++k) {
    std::array<long, 3> cell{};
    long rest = k;
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a, rest /= across)
      cell[a] = std::lround(std::floor(particle.position[a] / spacing +
                                       static_cast<double>(rest % across) -
                                       0.5 * static_cast<double>(across - 1)));
    covered.insert(cell);
  }
}

// Each cell of the uniform body is covered exactly once, and no other cell is covered.
void expect_same_room(const Body& body, int dimension) {
  Body uniform = body;
  uniform.grading.levels = 0;
  std::multiset<std::array<long, 3>> expected, covered;
  for (const Point& point : fill(uniform, dimension))
    cover({point, 0}, body.spacing, dimension, expected);
  std::size_t count = 0;
  for (const GradedParticle& particle : fill_levels(body, dimension)) {
    cover(particle, body.spacing, dimension, covered);
    ++count;
  }
  EXPECT_EQ(covered, expected);
  EXPECT_LT(count, (dimension == 2 ? 0.6 : 0.4) * static_cast<double>(expected.size()));
}

TEST(GradedFill, HasTheVolumeOfTheUniformBody) {
  auto body = graded_body(holed_box(), 1e-3, 2, 8e-3);
  body.grading.lines = {{{0.0, 27e-3, 10e-3}, {0.0, -1.0, 0.0}, 2e-3}};
  expect_same_room(body, 2);
  expect_same_room(body, 3);
}

// No particle is coarser than its nearest point allows, and no cell is split unnecessarily: the
// lattice has whole cells.
TEST(GradedFill, SpacingFollowsTheDistance) {
  auto body = graded_body(box_between({-64e-3, 0.0, 0.0}, {64e-3, 32e-3, 0.0}), 1e-3, 3, 10e-3);
  body.grading.around = box_between({-4e-3, 20e-3, 0.0}, {4e-3, 40e-3, 0.0});
  for (const GradedParticle& particle : fill_levels(body, 2)) {
    const double half = 0.5 * level_spacing(body, particle.level);
    const double distance = distance_from_finest(body.grading, particle.position, 2);
    if (particle.level > 0) {
      EXPECT_GE(distance - half * std::sqrt(2.0), 10e-3 * particle.level - 1e-12);
    }
    // Its parent is twice as wide, with its centre at most half a diagonal away.
    if (particle.level < 3) {
      EXPECT_LT(distance - 3.0 * half * std::sqrt(2.0), 10e-3 * (particle.level + 1));
    }
  }
}

// By a brute-force test the cells of two particles in contact differ by one level at most.
TEST(GradedFill, NeighboursDifferByOneLevel) {
  auto body = graded_body(holed_box(), 1e-3, 3, 8e-3);  // the smallest accepted width
  body.grading.lines = {{{-20e-3, 27e-3, 10e-3}, {0.6, -0.8, 0.0}, 2e-3}};
  const auto particles = fill_levels(body, 2);
  int jumps = 0;
  for (const auto& a : particles)
    for (const auto& b : particles) {
      const double reach = 0.5 * (level_spacing(body, a.level) + level_spacing(body, b.level));
      if (std::abs(a.position[0] - b.position[0]) > 1.001 * reach ||
          std::abs(a.position[1] - b.position[1]) > 1.001 * reach)
        continue;
      EXPECT_LE(std::abs(a.level - b.level), 1);
      jumps += a.level != b.level;
    }
  EXPECT_GT(jumps, 0);
}

// A body that is symmetric about the jet has a symmetric layout.
TEST(GradedFill, KeepsSymmetry) {
  auto body = graded_body(box_between({-51e-3, 0.0, 0.0}, {51e-3, 25e-3, 0.0}), 1e-3, 2, 8e-3);
  body.grading.lines = {{{0.0, 25e-3, 0.0}, {0.0, -1.0, 0.0}, 5e-3}};
  std::multiset<std::array<double, 3>> places, mirrored;
  for (const GradedParticle& particle : fill_levels(body, 2)) {
    const auto& x = particle.position;
    places.insert({std::round(1e9 * x[0]), std::round(1e9 * x[1]), double(particle.level)});
    mirrored.insert({std::round(-1e9 * x[0]), std::round(1e9 * x[1]), double(particle.level)});
  }
  EXPECT_EQ(places, mirrored);
}

TEST(GradedFill, UniformBodiesAreUnchanged) {
  const auto body = graded_body(holed_box(), 1e-3, 0, 0.0);
  const auto particles = fill_levels(body, 2);
  const auto points = fill(body, 2);
  ASSERT_EQ(particles.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(particles[i].position, points[i]);
}

}  // namespace
}  // namespace kerf
