// SPDX-License-Identifier: Apache-2.0
// Pressure part of the momentum equation (26) of Shinohara et al. (2004), over all pairs:
//   dv_i/dt = - sum_j m_j (p_i + p_j) / (rho_i rho_j) nabla_i W_ij.
// Fractured solid and separate pieces of solid exert no tension on each other (section 2.3: "only
// compressive force acts"). The work against these forces is the thermal
// energy equation that belongs to them (Monaghan 1992), half of a pair's on each side:
//   du_i/dt = 1/2 sum_j m_j (p_i + p_j) / (rho_i rho_j) v_ij . nabla_i W_ij.
#pragma once

#include "pairs/pair.hpp"

namespace kerf {

template <int D, class P>
struct PressureForce {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Vector<D, Real> pressure{};
    Real pressure_power{};
  };

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    Real p_i = particles.pressure[pair.i];
    Real p_j = particles.pressure[pair.j];
    if (pair.same_phase && !pair.cohesive) {
      p_i = p_i > Real(0) ? p_i : Real(0);
      p_j = p_j > Real(0) ? p_j : Real(0);
    }
    const Real density_product = particles.density(pair.i) * particles.density(pair.j);
    const auto force = (pair.medium_j->mass * (p_i + p_j) / density_product) * pair.gradient;
    sum.pressure -= force;
    sum.pressure_power += Real(0.5) * dot(pair.velocity, force);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.acceleration[i] += sum.pressure;
    particles.pressure_power[i] = sum.pressure_power;
  }
};

}  // namespace kerf
