// SPDX-License-Identifier: Apache-2.0
// Small cases as plain data for runs of a few hundred steps.
#pragma once

#include <limits>

#include "model/case.hpp"

namespace kerf::test {

inline constexpr auto both_precisions = {PrecisionKind::mixed, PrecisionKind::double_precision};

inline Material tofu() {
  Material m;
  m.name = "tofu";
  m.kind = MaterialKind::elastic;
  m.density = 940.0;
  m.youngs_modulus = 1.0e5;
  m.poisson_ratio = 0.3;
  m.failure_strain = 0.1;
  m.artificial_linear = m.artificial_quadratic = 2.5;
  return m;
}

inline Material water(double sound_speed) {
  Material m;
  m.name = "water";
  m.kind = MaterialKind::water;
  m.density = 1000.0;
  m.viscosity = 1e-3;
  m.sound_speed = sound_speed;
  m.artificial_linear = 0.01;
  return m;
}

inline Shape box(const Point& minimum, const Point& maximum) {
  Shape shape;
  shape.kind = Shape::Kind::box;
  shape.box = {minimum, maximum};
  return shape;
}

// Materials: 0 tofu, 1 water with a sound speed of 50 m/s. No bodies; a domain of 0.3 m around the
// origin.
inline Case empty_case(int dimension, PrecisionKind precision) {
  Case c;
  c.title = "test";
  c.formulation = Formulation::shinohara2004;
  c.smoothing_ratio = 1.5;
  c.time.courant = 0.25;
  c.dimension = dimension;
  c.precision = precision;
  c.time.end = 1.0;
  c.time.maximum_step = std::numeric_limits<double>::infinity();
  c.domain = {{-0.15, -0.15, -0.15}, {0.15, 0.15, 0.15}};
  c.materials = {tofu(), water(50.0)};
  return c;
}

inline Body body(const char* name, Role role, const Shape& shape, double spacing) {
  Body b;
  b.name = name;
  b.role = role;
  b.material = role == Role::elastic ? 0 : role == Role::water ? 1 : -1;
  b.shape = shape;
  b.spacing = spacing;
  if (role == Role::rigid) b.repulsion = 25.0;
  return b;
}

inline Jet jet(double width, double spacing, const Point& position, double standoff) {
  Jet j;
  j.name = "jet";
  j.material = 1;
  j.speed = 5.0;
  j.width = width;
  j.position = position;
  j.standoff = standoff;
  j.spacing = spacing;
  j.stop = std::numeric_limits<double>::infinity();
  return j;
}

// A jet hits a small block of tofu on a plate: inflow, impact, fracture, and outflow over the edges
// of a narrow domain. The case is symmetric about x = 0 (and z = 0).
inline Case jet_on_block(int dimension, PrecisionKind precision) {
  Case c = empty_case(dimension, precision);
  const double z = dimension == 3 ? 1.0 : 0.0;
  c.domain = {{-0.012, -0.006, -0.012 * z}, {0.012, 0.03, 0.012 * z}};
  c.gravity = {0.0, -9.81, 0.0};
  c.bodies = {
      body("block", Role::elastic, box({-0.008, 0.0, -0.008 * z}, {0.008, 0.008, 0.008 * z}),
           dimension == 2 ? 1e-3 : 2e-3),
      body("plate", Role::rigid, box({-0.012, -0.004, -0.012 * z}, {0.012, 0.0, 0.012 * z}), 2e-3)};
  c.jets = {jet(5e-3, dimension == 2 ? 5e-4 : 1e-3, {0.0, 0.008, 0.0}, 2e-3)};
  return c;
}

// The same for the `standard` formulation, with solids and walls of the spacing of the water; the
// tofu is brittle and breaks at once.
inline Case standard_jet_on_block(int dimension, PrecisionKind precision) {
  Case c = jet_on_block(dimension, precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = 0.05;
  c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.5;
  for (Body& body : c.bodies) body.spacing = c.jets[0].spacing;
  return c;
}

inline Case jet_on_block(int dimension, PrecisionKind precision, Formulation formulation) {
  return formulation == Formulation::standard ? standard_jet_on_block(dimension, precision)
                                              : jet_on_block(dimension, precision);
}

}  // namespace kerf::test
