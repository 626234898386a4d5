// SPDX-License-Identifier: Apache-2.0
// FluidForce is the momentum equation of fluids, of nearly incompressible solids, and of what
// fluids press on, with the Riemann solution (Zhang, Hu & Adams 2017):
//   m_i dv_i/dt = - 2 sum_j V_i V_j P* nabla_i W_ij.
// The forces on the two particles of a pair are equal and opposite. The dissipative part is kept
// apart for the energy balance.
#pragma once

#include "fluid/fluid_pair.hpp"
#include "fluid/known_sums.hpp"
#include "fluid/pair_terms.hpp"

namespace kerf {

template <int D, class P>
struct FluidForce {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Vector<D, Real> pressure_force{}, dissipative_force{}, wall_force{};  // N
  };
  FluidPair<D, P> fluid_pair;
  KnownSums<D, Real> known{};

  KERF_FUNCTION void start(const ParticleView<D, P>&, Index i, Sum& sum) const {
    if (!known.are_known()) return;
    sum.pressure_force = known[i].pressure_force();
    sum.dissipative_force = known[i].dissipative_force();
  }
  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const PairInteraction kind = interaction_of(particles, pair);
    if (kind == PairInteraction::nothing || !(pair.distance > Real(0))) return;
    const Real weight =
        Real(2) * fluid_pair.gradient_factor(particles, pair) *
        volume_of(particles, pair.i, *pair.medium_i) *
        pair_weight(volume_of(particles, pair.j, *pair.medium_j), pair.slope_per_distance);
    if (has_smooth_wall(particles, pair, kind)) {
      const auto star = fluid_pair.at_smooth_wall(particles, pair, kind);
      sum.pressure_force += weight * star.pressure;
      sum.dissipative_force += weight * star.dissipation;
      if (pair.medium_j->phase == Phase::rigid)
        sum.wall_force += weight * (star.pressure + star.dissipation);
      return;
    }
    const auto star = fluid_pair(particles, pair, kind);
    const auto pressure_force = pair_force(weight, star.mean_pressure, pair.separation);
    const auto dissipative_force =
        pair_force(weight, star.dissipation, fluid_pair.damped_direction(particles, pair, kind));
    sum.pressure_force += pressure_force;
    sum.dissipative_force += dissipative_force;
  }
  KERF_FUNCTION static Vector<D, Real> force(const Sum& sum) {
    return sum.pressure_force + sum.dissipative_force - sum.wall_force;
  }
  KERF_FUNCTION Vector<D, Real> known_image_force(Index i) const {
    return known.are_known() ? known[i].image_force : Vector<D, Real>::zero();
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid) return;
    const Real inverse = Real(1) / medium.mass;
    particles.pressure_acceleration[i] = inverse * sum.pressure_force;
    particles.damping_acceleration[i] = inverse * sum.dissipative_force;
    particles.acceleration[i] += inverse * (sum.pressure_force + sum.dissipative_force);
    particles.repulsion[i] = inverse * sum.wall_force;
  }

 private:
  // Whether one of the two is of a smooth wall beside the other.
  KERF_FUNCTION static bool has_smooth_wall(const ParticleView<D, P>& particles,
                                            const Pair<D, P>& pair, PairInteraction kind) {
    if (kind == PairInteraction::i_is_wall)
      return is_smooth_wall(particles, pair.i, *pair.medium_i, *pair.medium_j);
    return kind == PairInteraction::j_is_wall && is_at_smooth_wall(particles, pair);
  }
};

}  // namespace kerf
