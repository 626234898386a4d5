// SPDX-License-Identifier: Apache-2.0
// Continuity of fluids, and of nearly incompressible solids, with the Riemann solution (Zhang, Hu &
// Adams 2017):
//   d rho_i/dt = 2 rho_i sum_j V_j (v_i - v*) . nabla_i W_ij,   v* . e = - U*,
// over the fluid and the solid beside it, kept as the rate of compression rho/rho_0 - 1. On the way
// it finds the normal of the wall that a fluid particle is at, for the next step.
#pragma once

#include "rates/alike_sums.hpp"
#include "rates/fluid_pair.hpp"

namespace kerf {

template <int D, class P>
struct FluidContinuity {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Real strain_rate{};      // 1/s, of the volume, negative
    Vector<D, Real> wall{};  // 1/m, - sum V nabla W over the wall: its normal
  };
  FluidPair<D, P> fluid_pair;
  AlikeSums<D, Real> alike{};
  // h |sum V nabla W| is about 1/2 at a wall; much less between two that face each other.
  static constexpr double least_wall = 0.02;

  KERF_FUNCTION void start(const ParticleView<D, P>&, Index i, Sum& sum) const {
    if (alike.are_known()) sum.strain_rate = alike[i].strain_rate();
  }
  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const Meeting kind = meeting(particles, pair);
    if (kind != Meeting::alike && kind != Meeting::wall_of_i) return;
    if (!(pair.distance > Real(0))) return;
    const auto star = fluid_pair(particles, pair, kind);
    const Real u_i = -dot(particles.velocity[pair.i], pair.separation) / pair.distance;
    // (v_i - v*) . nabla W = - (U_i - U*) dW/dr.
    const Real slope = dot(pair.gradient, pair.separation) / pair.distance;
    const Real volume = volume_of(particles, pair.j, *pair.medium_j);
    sum.strain_rate -=
        Real(2) * fluid_pair.steepness(particles, pair) * volume * (u_i - star.speed) * slope;
    if (kind == Meeting::wall_of_i) sum.wall -= volume * pair.gradient;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.compression_rate[i] = (Real(1) + particles.compression[i]) * sum.strain_rate;
    const Real length = norm(sum.wall);
    const bool plain = length * particles.medium(i).smoothing_length > Real(least_wall);
    particles.next_wall_normal[i] = plain ? (Real(1) / length) * sum.wall : Vector<D, Real>::zero();
  }
};

}  // namespace kerf
