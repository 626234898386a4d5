// SPDX-License-Identifier: Apache-2.0
// Loads on bodies: their sum, work and restart, whatever the angle of the face to the lattice.
#include <cmath>
#include <numbers>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

Case free_body(int dimension, PrecisionKind precision, const Shape& shape) {
  Case c = empty_case(dimension, precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = 0.0;
  c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.0;
  c.bodies = {body("body", Role::elastic, shape, 1e-3)};
  return c;
}

// A rectangle of 20 x 8 mm, turned about its middle.
Shape turned_block(double angle) {
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

// A region that holds the right end and 0.1 mm of both sides.
Shape at_end(double angle) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  for (const auto& [x, y] :
       {std::pair{0.0099, -0.005}, {0.02, -0.005}, {0.02, 0.005}, {0.0099, 0.005}})
    shape.vertices.push_back(
        {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)});
  shape.depth_minimum = -0.01;
  shape.depth_maximum = 0.01;
  return shape;
}

Load load_of(LoadKind kind, const Shape& region) {
  Load load;
  load.kind = kind;
  load.body = "body";
  load.region = region;
  return load;
}

// The momentum of a free body grows by force times time, at any angle; the force is traction or
// pressure times the area of the end, 8 mm and 0.1 mm of each side, whose pressures cancel.
TEST(Loads, SumIsTractionTimesArea) {
  for (const double angle : {0.0, 0.35, 0.7, 1.2}) {
    Case c = free_body(2, PrecisionKind::double_precision, turned_block(angle));
    c.loads = {load_of(LoadKind::traction, at_end(angle)),
               load_of(LoadKind::pressure, at_end(angle))};
    c.loads[0].traction = {30.0, -20.0, 0.0};
    c.loads[1].pressure = 40.0;
    const auto simulation = make_simulation(c);
    simulation->advance();
    const Balance now = simulation->balance();
    const double dt = simulation->last_step().dt;
    // Elements of a 32nd of the spacing; those of the sides end within one of the region.
    const double area = 0.008 + 2e-4, end = 2e-3 / 32.0;
    EXPECT_NEAR(now.impulse_load[0], (30.0 * area - 40.0 * 0.008 * std::cos(angle)) * dt,
                30.0 * end * dt);
    EXPECT_NEAR(now.impulse_load[1], (-20.0 * area - 40.0 * 0.008 * std::sin(angle)) * dt,
                20.0 * end * dt + 40.0 * 1e-12 * dt);
    EXPECT_LT(now.momentum_error(), 1e-12);
  }
}

// A body force on the whole body is gravity: the same fall, to the bits of the acceleration.
TEST(Loads, BodyForceIsGravity) {
  for (const int dimension : {2, 3})
    for (const PrecisionKind precision : both_precisions) {
      Case c = free_body(dimension, precision, turned_block(0.2));
      Load load;
      load.kind = LoadKind::body_force;
      load.body = "body";
      load.acceleration = {1.0, -9.81, 0.0};
      load.history = "2*t/1e-3";
      c.loads = {load};
      c.time.end = 1e-3;
      c.time.maximum_step = 1e-5;
      const auto simulation = make_simulation(c);
      while (!simulation->finished()) simulation->advance();
      const Balance now = simulation->balance();
      // The middle of each step: the integral of a linear history is exact.
      const double rounding = precision == PrecisionKind::mixed ? 1e-5 : 1e-10;
      EXPECT_NEAR(now.momentum_now[1], -9.81e-3 * now.mass_now, rounding * 9.81e-3 * now.mass_now);
      EXPECT_NEAR(now.momentum_now[0], 1e-3 * now.mass_now, rounding * 9.81e-3 * now.mass_now);
      EXPECT_NEAR(now.work_load, now.kinetic, 10.0 * rounding * now.kinetic);
      EXPECT_LT(now.momentum_error(), rounding);
    }
}

// Loads that balance one another leave rounding of momentum alone: relative to their impulse by
// magnitude it is small, also of a body that they have brought to rest.
TEST(Loads, MomentumOfBalancedLoadsIsRelativeToTheirMagnitude) {
  for (const double angle : {0.0, 0.5}) {
    Case c = free_body(2, PrecisionKind::double_precision, turned_block(angle));
    c.loads = {load_of(LoadKind::traction, at_end(angle)),
               load_of(LoadKind::traction, at_end(angle + std::numbers::pi))};
    c.loads[0].traction = {100.0 * std::cos(angle), 100.0 * std::sin(angle), 0.0};
    c.loads[1].traction = {-100.0 * std::cos(angle), -100.0 * std::sin(angle), 0.0};
    for (Load& load : c.loads) load.history = "min(t/0.002, 1)";
    c.time.relax = c.time.end = 0.02;
    const auto simulation = make_simulation(c);
    while (!simulation->finished()) simulation->advance();
    const Balance now = simulation->balance();
    EXPECT_NEAR(now.load_scale, 2.0 * 100.0 * 0.0082 * 0.019, 0.02 * now.load_scale);
    EXPECT_LT(now.momentum_error(), 1e-11) << angle;
  }
}

// A face of a block in 3D, at an angle to the lattice.
TEST(Loads, SumInSpace) {
  Case c = free_body(3, PrecisionKind::mixed, turned_block(0.4));
  c.loads = {load_of(LoadKind::pressure, at_end(0.4))};
  c.loads[0].pressure = 50.0;
  const auto simulation = make_simulation(c);
  simulation->advance();
  const Balance now = simulation->balance();
  const double force = 50.0 * 0.008 * 0.006 * simulation->last_step().dt;
  EXPECT_NEAR(now.impulse_load[0], -force * std::cos(0.4), 1e-5 * force);
  EXPECT_NEAR(now.impulse_load[1], -force * std::sin(0.4), 1e-5 * force);
  EXPECT_NEAR(now.impulse_load[2], 0.0, 1e-5 * force);
}

// The same pressure (Pa) on what lies beside a plane, to both sides: not one load all around, which
// acts on the particles' own surface.
std::vector<Load> pressure_in_two_parts(double pressure) {
  const double plane = 2.0137e-3;
  std::vector<Load> loads{
      load_of(LoadKind::pressure, box({-0.01, -0.01, -0.01}, {0.01, plane, 0.01})),
      load_of(LoadKind::pressure, box({-0.01, plane, -0.01}, {0.01, 0.01, 0.01}))};
  for (Load& load : loads) load.pressure = pressure;
  return loads;
}

// A ball or a disc of 6 spacings cut by symmetry planes through its middle: pressure times the area
// of a section along each axis. Elements of a quarter of a spacing (2D: a 32nd) are accurate to the
// square of their angle.
TEST(Loads, PressureOnACurvedFaceIsTheSameAlongAllPlanes) {
  for (const int dimension : {2, 3}) {
    Shape round;
    round.kind = dimension == 3 ? Shape::Kind::sphere : Shape::Kind::disc;
    round.radius = 6e-3;
    Case c = free_body(dimension, PrecisionKind::double_precision, round);
    c.domain.minimum = {0.0, 0.0, dimension == 3 ? 0.0 : -0.15};
    c.symmetry.minimum = {true, true, dimension == 3};
    c.loads = pressure_in_two_parts(40.0);
    const auto simulation = make_simulation(c);
    simulation->advance();
    const double section = dimension == 3 ? std::numbers::pi * 36e-6 / 4.0 : 6e-3;
    const double impulse = 40.0 * section * simulation->last_step().dt;
    const Balance now = simulation->balance();
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
      EXPECT_NEAR(now.impulse_load[a], -impulse, 4e-4 * impulse) << dimension << ' ' << a;
    EXPECT_NEAR(now.impulse_load[0], now.impulse_load[1], 1e-5 * impulse) << dimension;
  }
}

// Half a disc has no load along its plane.
TEST(Loads, PressureOnHalfADiscDoesNotMoveItAlongItsPlane) {
  for (const std::size_t across : {std::size_t(0), std::size_t(1)}) {
    Shape disc;
    disc.kind = Shape::Kind::disc;
    disc.radius = 6.1e-3;
    Case c = free_body(2, PrecisionKind::double_precision, disc);
    c.domain.minimum[across] = 0.0;
    c.symmetry.minimum[across] = true;
    c.loads = pressure_in_two_parts(40.0);
    const auto simulation = make_simulation(c);
    simulation->advance();
    const double impulse = 40.0 * 2.0 * 6.1e-3 * simulation->last_step().dt;
    const Balance now = simulation->balance();
    EXPECT_NEAR(now.impulse_load[across], -impulse, 1e-5 * impulse);
    EXPECT_NEAR(now.impulse_load[1 - across], 0.0, 1e-7 * impulse);
  }
}

TEST(Loads, SameBitsAfterRestart) {
  Case c = standard_jet_on_block(2, PrecisionKind::mixed);
  c.loads = {load_of(LoadKind::pressure, box({-0.009, -0.001, 0.0}, {-0.0079, 0.009, 0.0}))};
  c.loads[0].body = "block";
  c.loads[0].pressure = 500.0;
  c.loads[0].history = "sin(5000*t)";
  EXPECT_NE(expect_same_bits_after_restart(c).impulse_load[0], 0.0);
}

}  // namespace
}  // namespace kerf::test
