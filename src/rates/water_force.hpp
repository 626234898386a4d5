// SPDX-License-Identifier: Apache-2.0
// Momentum of water, and of the solid beside it, with the Riemann solution (Zhang, Hu & Adams
// 2017):  m_i dv_i/dt = - 2 sum_j V_i V_j P* nabla_i W_ij.
// The force is the same for both of a pair but for its sign. The part that dissipates is kept apart
// for the ledger.
#pragma once

#include "rates/riemann.hpp"

namespace kerf {

template <int D, class P>
struct WaterForce {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Vector<D, Real> water{}, water_dissipation{}, wall{};
  };
  WaterPair<D, P> water_pair;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const bool water_i = pair.medium_i->phase == Phase::water;
    if (!water_i && pair.medium_j->phase != Phase::water) return;
    if (!(pair.distance > Real(0))) return;
    const auto star = water_pair(particles, pair);
    const auto push = Real(-2) * volume_of(particles, pair.i, *pair.medium_i) *
                      volume_of(particles, pair.j, *pair.medium_j) * pair.gradient;
    sum.water += star.mean_pressure * push;
    sum.water_dissipation += star.dissipation * push;
    if (pair.medium_j->phase == Phase::rigid)
      sum.wall += (star.mean_pressure + star.dissipation) * push;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid) return;
    const Real inverse = Real(1) / medium.mass;
    particles.pressure_acceleration[i] = inverse * sum.water;
    particles.damping_acceleration[i] = inverse * sum.water_dissipation;
    particles.acceleration[i] += inverse * (sum.water + sum.water_dissipation);
    particles.repulsion[i] = inverse * sum.wall;
  }
};

}  // namespace kerf
