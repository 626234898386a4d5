// SPDX-License-Identifier: Apache-2.0
// A random mixture of particles of all phases for tests of pair sums: fine and coarse water, three
// pieces of solid of different spacing, intact and fractured, and a rigid body.
#pragma once

#include <random>

#include "support/reference_sph.hpp"

namespace kerf::test {

struct MixtureChoice {
  int dimension = 2;
  unsigned seed = 1;
  int per_side = 14;
  double jitter = 0.3;  // of the spacing
  bool rigid = true;
};

inline constexpr double mixture_spacing = 1e-3;  // m

inline Medium<double> mixture_water(double spacing, int dimension) {
  Medium<double> water;
  water.phase = Phase::water;
  water.spacing = spacing;
  water.density = 1000.0;
  water.sound_speed = water.longitudinal_speed = 50.0;
  water.tait.exponent = 7.0;
  water.tait.coefficient = 50.0 * 50.0 * 1000.0 / 7.0;
  water.viscosity = 0.9;
  water.artificial_linear = 0.01;
  water.artificial_softening = 0.1;
  water.smoothing_length = 1.5 * spacing;
  water.mass = water.density * std::pow(spacing, dimension);
  return water;
}

inline Medium<double> mixture_solid(double spacing, int dimension, std::uint16_t piece) {
  Medium<double> solid;
  solid.phase = Phase::solid;
  solid.piece = piece;
  solid.spacing = spacing;
  solid.density = 940.0;
  solid.total_bulk_modulus = solid.bulk_modulus = 8.3e4;
  solid.shear_modulus = 3.8e4;
  solid.sound_speed = std::sqrt(solid.bulk_modulus / solid.density);
  solid.longitudinal_speed = 12.0;
  solid.failure_strain = 0.1;
  solid.artificial_linear = solid.artificial_quadratic = 2.5;
  solid.artificial_softening = 0.1;
  solid.smoothing_length = 1.5 * spacing;
  solid.mass = solid.density * std::pow(spacing, dimension);
  return solid;
}

inline Medium<double> mixture_rigid(double spacing) {
  Medium<double> rigid;
  rigid.phase = Phase::rigid;
  rigid.constrained = true;
  rigid.spacing = spacing;
  rigid.repulsion = 25.0;
  rigid.smoothing_length = 1.5 * spacing;
  return rigid;
}

// Returns a random symmetric tensor of trace 0, with xz = yz = 0 in two dimensions.
template <class Random>
Matrix3 random_deviator(int dimension, Random&& uniform) {
  Matrix3 s = Matrix3::Zero();
  for (int a = 0; a < 3; ++a) s(a, a) = uniform();
  for (int a = 0; a < dimension; ++a)
    for (int b = a + 1; b < dimension; ++b) s(a, b) = s(b, a) = uniform();
  return s - s.trace() / 3.0 * Matrix3::Identity();
}

inline ReferenceState random_mixture(const MixtureChoice& choice) {
  std::mt19937 engine(choice.seed);
  std::uniform_real_distribution<double> distribution(-1.0, 1.0);
  const auto uniform = [&] { return distribution(engine); };
  const int d = choice.dimension;
  const double step = mixture_spacing;
  ReferenceState state;
  state.dimension = d;
  state.media = {mixture_water(step, d),          mixture_water(2.0 * step, d),
                 mixture_solid(step, d, 2),       mixture_solid(2.0 * step, d, 2),
                 mixture_solid(4.0 * step, d, 4), mixture_rigid(2.0 * step)};
  const int layers = d == 3 ? choice.per_side : 1;
  const std::size_t kinds = state.media.size() - (choice.rigid ? 0 : 1);
  for (int k = 0; k < choice.per_side * choice.per_side * layers; ++k) {
    ReferenceParticle particle;
    const int cell[3] = {k % choice.per_side, k / choice.per_side % choice.per_side,
                         k / (choice.per_side * choice.per_side)};
    for (int a = 0; a < d; ++a) {
      particle.position[a] = step * (cell[a] + 0.5 + choice.jitter * uniform());
      particle.velocity[a] = 5.0 * uniform();
    }
    particle.source = engine() % kinds;
    const Phase phase = state.media[particle.source].phase;
    if (phase != Phase::rigid) particle.compression = 0.02 * uniform();
    if (phase == Phase::solid) {
      particle.fractured = uniform() > 0.4;
      if (!particle.fractured) particle.shear = 5e3 * random_deviator(d, uniform);
    }
    particle.repelling = phase == Phase::rigid && uniform() > -0.6;
    state.particles.push_back(particle);
  }
  return state;
}

// The same spread over a cube of this width, m, so that it covers many cells; none is rigid.
inline ReferenceState spread_mixture(int dimension, unsigned seed, double width) {
  MixtureChoice choice;
  choice.dimension = dimension;
  choice.seed = seed;
  choice.jitter = 0.45;
  choice.per_side = dimension == 2 ? 40 : 14;
  ReferenceState state = random_mixture(choice);
  double extent = 0.0;
  for (const auto& particle : state.particles)
    extent = std::max(extent, particle.position.maxCoeff());
  for (auto& particle : state.particles) {
    particle.position *= 0.9 * width / extent;
    for (int a = 0; a < dimension; ++a) particle.position[a] += 0.05 * width;
    if (state.medium(&particle - state.particles.data()).phase == Phase::rigid) particle.source = 0;
  }
  return state;
}

}  // namespace kerf::test
