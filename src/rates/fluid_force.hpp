// SPDX-License-Identifier: Apache-2.0
// Momentum of fluids, of nearly incompressible solids, and of what fluids press on, with the
// Riemann solution (Zhang, Hu & Adams 2017):  m_i dv_i/dt = - 2 sum_j V_i V_j P* nabla_i W_ij. The
// force is the same for both of a pair but for its sign. The part that dissipates is kept apart for
// the ledger.
#pragma once

#include "rates/alike_sums.hpp"
#include "rates/fluid_pair.hpp"

namespace kerf {

template <int D, class P>
struct FluidForce {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Vector<D, Real> pressing{}, dissipation{}, wall{};
  };
  FluidPair<D, P> fluid_pair;
  AlikeSums<D, Real> alike{};

  KERF_FUNCTION void start(const ParticleView<D, P>&, Index i, Sum& sum) const {
    if (!alike.are_known()) return;
    sum.pressing = alike[i].pressing();
    sum.dissipation = alike[i].damping();
  }
  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const Meeting kind = meeting(particles, pair);
    if (kind == Meeting::nothing || !(pair.distance > Real(0))) return;
    const auto star = fluid_pair(particles, pair, kind);
    const auto push = Real(-2) * fluid_pair.steepness(particles, pair) *
                      volume_of(particles, pair.i, *pair.medium_i) *
                      volume_of(particles, pair.j, *pair.medium_j) * pair.gradient;
    const auto pressing = star.mean_pressure * push;
    const auto damping = star.dissipation * fluid_pair.damped(particles, pair, kind, push);
    sum.pressing += pressing;
    sum.dissipation += damping;
    if (pair.medium_j->phase == Phase::rigid) sum.wall += pressing + damping;
  }
  KERF_FUNCTION static Vector<D, Real> force(const Sum& sum) {
    return sum.pressing + sum.dissipation - sum.wall;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid) return;
    const Real inverse = Real(1) / medium.mass;
    particles.pressure_acceleration[i] = inverse * sum.pressing;
    particles.damping_acceleration[i] = inverse * sum.dissipation;
    particles.acceleration[i] += inverse * (sum.pressing + sum.dissipation);
    particles.repulsion[i] = inverse * sum.wall;
  }
};

}  // namespace kerf
