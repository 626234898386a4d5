// SPDX-License-Identifier: Apache-2.0
// A pressure on the whole surface of a body leaves the stress - p 1 in it, whatever its shape and
// however it lies to the lattice: it moves by a uniform compression alone, with the strain
// p / (2 (K + G / 3)) in plane strain and p / (3 K) in space, and neither moves off nor turns.
#include <cmath>
#include <map>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test::pressure_all_around {
namespace {

constexpr double pressure = 100.0, modulus = 1e5, poisson = 0.3;

Case pressed(int dimension, PrecisionKind precision, const Shape& shape) {
  Case c = empty_case(dimension, precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = 0.0;
  c.materials[0].artificial_linear = 2.5;
  c.materials[0].artificial_quadratic = 0.0;
  c.bodies = {body("body", Role::elastic, shape, 1e-3)};
  Load load;
  load.kind = LoadKind::pressure;
  load.body = "body";
  load.pressure = pressure;
  load.history = "min(t/0.005, 1)";
  c.loads = {load};
  c.time.relax = c.time.end = dimension == 2 ? 0.03 : 0.015;
  return c;
}

Shape block_turned_by(double angle) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  for (const auto& [x, y] :
       {std::pair{-0.01, -0.004}, {0.01, -0.004}, {0.01, 0.004}, {-0.01, 0.004}})
    shape.vertices.push_back(
        {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)});
  shape.depth_minimum = -0.003;
  shape.depth_maximum = 0.003;
  return shape;
}

Shape round(Shape::Kind kind, const Point& centre, double radius) {
  Shape shape;
  shape.kind = kind;
  shape.centre = centre;
  shape.radius = radius;
  return shape;
}

struct Motion {
  std::vector<Point> from, by;  // m: against the middle of the body; against a plane in a half
  Point of_middle{};            // m
};

Motion motion_of(const Case& c) {
  const auto simulation = make_simulation(c);
  const Frame before = simulation->frame();
  while (!simulation->finished()) simulation->advance();
  const Frame after = simulation->frame();
  std::map<std::uint32_t, Point> start;
  for (std::size_t i = 0; i < before.id.size(); ++i) start[before.id[i]] = before.position[i];
  Motion motion;
  Point from{}, by{};  // of the centre of mass
  double mass = 0.0;
  for (const float of_particle : after.mass) mass += of_particle;
  for (std::size_t i = 0; i < after.id.size(); ++i) {
    const Point& x = start.at(after.id[i]);
    motion.from.push_back(x);
    motion.by.push_back({});
    for (std::size_t a = 0; a < 3; ++a) {
      motion.by[i][a] = after.position[i][a] - x[a];
      from[a] += after.mass[i] / mass * x[a];
      by[a] += after.mass[i] / mass * motion.by[i][a];
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    if (c.symmetry.minimum[a]) continue;
    for (Point& x : motion.from) x[a] -= from[a];
    for (Point& u : motion.by) u[a] -= by[a];
    motion.of_middle[a] = by[a];
  }
  return motion;
}

// `tolerance`: of the greatest motion of theory.
void expect_uniform_compression(const Case& c, double tolerance) {
  const double k = modulus / (3.0 * (1.0 - 2.0 * poisson)), g = modulus / (2.0 * (1.0 + poisson));
  const double strain = c.dimension == 2 ? pressure / (2.0 * (k + g / 3.0)) : pressure / (3.0 * k);
  const Motion motion = motion_of(c);
  double farthest = 0.0;
  for (const Point& x : motion.from)
    for (const double along : x) farthest = std::max(farthest, std::abs(along));
  for (const double along : motion.of_middle)
    EXPECT_NEAR(along, 0.0, tolerance * strain * farthest);
  for (std::size_t i = 0; i < motion.by.size(); ++i)
    for (std::size_t a = 0; a < static_cast<std::size_t>(c.dimension); ++a)
      ASSERT_NEAR(motion.by[i][a], -strain * motion.from[i][a], tolerance * strain * farthest)
          << i << ' ' << a;
}

// The strain of 0.05% is finite: J^-1 of the Cauchy stress changes its effect by as much.
constexpr double finite = 5e-3;

TEST(PressureAllAround, CompressesABlockAtAnyAngle) {
  for (const PrecisionKind precision : both_precisions)
    for (const double angle : {0.0, 0.35, 0.7}) {
      SCOPED_TRACE(angle);
      expect_uniform_compression(pressed(2, precision, block_turned_by(angle)), finite);
    }
}

TEST(PressureAllAround, CompressesABlockWithAHole) {
  Shape shape;
  shape.kind = Shape::Kind::difference;
  shape.parts = {block_turned_by(0.0), round(Shape::Kind::disc, {1.3e-3, -0.6e-3, 0.0}, 2e-3)};
  // The region of the load may as well be given.
  Case c = pressed(2, PrecisionKind::mixed, shape);
  expect_uniform_compression(c, finite);
  c.loads[0].region = box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
  expect_uniform_compression(c, finite);
}

TEST(PressureAllAround, CompressesAGradedBlock) {
  Case c = pressed(2, PrecisionKind::mixed, block_turned_by(0.0));
  Grading grading;
  grading.levels = 1;
  grading.width = 2e-3;
  grading.around = round(Shape::Kind::disc, {1.1e-3, -0.7e-3, 0.0}, 2e-3);
  c.bodies[0].spacing = 0.5e-3;
  c.bodies[0].grading = grading;
  expect_uniform_compression(c, finite);
}

TEST(PressureAllAround, CompressesAPartBetweenSymmetryPlanesLikeTheWhole) {
  Case c = pressed(2, PrecisionKind::mixed, round(Shape::Kind::disc, {}, 6.2e-3));
  c.domain.minimum[0] = 0.0;
  c.symmetry.minimum[0] = true;
  expect_uniform_compression(c, finite);
}

TEST(PressureAllAround, CompressesBodiesInSpace) {
  expect_uniform_compression(pressed(3, PrecisionKind::mixed, block_turned_by(0.4)), finite);
  expect_uniform_compression(
      pressed(3, PrecisionKind::mixed, round(Shape::Kind::sphere, {0.3e-3, 0.0, 0.0}, 4.3e-3)),
      finite);
}

}  // namespace
}  // namespace kerf::test::pressure_all_around
