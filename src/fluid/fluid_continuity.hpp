// SPDX-License-Identifier: Apache-2.0
// FluidContinuity is the continuity equation of fluids, and of nearly incompressible solids, with
// the Riemann solution (Zhang, Hu & Adams 2017):
//   d rho_i/dt = 2 rho_i sum_j V_j (v_i - v*) . nabla_i W_ij,   v* . e = - U*,
// over the fluid and the solid beside it. Its result is the rate of the relative density change
// rho/rho_0 - 1. It also finds the normal of the wall beside a fluid particle, for the next step.
#pragma once

#include "fluid/fluid_pair.hpp"
#include "fluid/known_sums.hpp"
#include "fluid/pair_terms.hpp"

namespace kerf {

template <int D, class P>
struct FluidContinuity {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Real compression_rate{};  // 1/s, minus the volumetric strain rate
    Real by_smooth_walls{};   // 1/s, the part of smooth walls, beside it
    Vector<D, Real> wall{};   // 1/m, - sum V nabla W over the wall, along its normal
  };
  FluidPair<D, P> fluid_pair;
  KnownSums<D, Real> known{};
  // h |sum V nabla W| is about 1/2 at a wall; much less between two that face each other.
  static constexpr double least_wall = 0.02;

  KERF_FUNCTION void start(const ParticleView<D, P>&, Index i, Sum& sum) const {
    if (!known.are_known()) return;
    sum.compression_rate = known[i].compression_rate();
    sum.wall = known[i].wall;
  }
  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const PairInteraction kind = interaction_of(particles, pair);
    if (kind != PairInteraction::interior && kind != PairInteraction::j_is_wall) return;
    if (!(pair.distance > Real(0))) return;
    const Real volume = volume_of(particles, pair.j, *pair.medium_j);
    const Real weight = Real(2) * fluid_pair.gradient_factor(particles, pair) *
                        pair_weight(volume, pair.slope_per_distance);
    if (kind == PairInteraction::j_is_wall) sum.wall -= volume * pair.gradient;
    if (is_at_smooth_wall(particles, pair)) {
      sum.by_smooth_walls -= weight * fluid_pair.at_smooth_wall(particles, pair, kind).parting;
      return;
    }
    const auto star = fluid_pair(particles, pair, kind);
    const Real u_i = -dot(particles.velocity[pair.i], pair.separation) / pair.distance;
    sum.compression_rate -= pair_strain_rate(weight, pair.distance, star.speed - u_i);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const bool is_compressed = sum.by_smooth_walls > Real(0);
    const Real share = Real(1) - (is_compressed ? room_at_wall(particles, i) : Real(0));
    particles.compression_rate[i] =
        (Real(1) + particles.compression[i]) * (sum.compression_rate + share * sum.by_smooth_walls);
    const Real length = norm(sum.wall);
    const bool plain = length * particles.medium(i).smoothing_length > Real(least_wall);
    particles.next_wall_normal[i] = plain ? (Real(1) / length) * sum.wall : Vector<D, Real>::zero();
  }
};

}  // namespace kerf
