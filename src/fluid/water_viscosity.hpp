// SPDX-License-Identifier: Apache-2.0
// WaterViscosity is the viscosity of water (Morris, Fox & Zhu, J. Comput. Phys. 136 (1997) 214),
// for constant mu:
//   m_i dv_i/dt = sum_j V_i V_j 2 mu v_ij / r_ij dW/dr,   mu: that of the water of the pair,
// with the kernel gradient normalised as for pressures: on a lattice the sum is short by the same
// slope. At walls and solids the water has their velocity (no slip).
#pragma once

#include "fluid/pair_terms.hpp"
#include "pairs/pair.hpp"

namespace kerf {

// Returns mu between two media, one of which is water, Pa s: the harmonic mean of two waters.
template <class Real>
KERF_FUNCTION Real viscosity_between(const Medium<Real>& a, const Medium<Real>& b) {
  if (a.phase != Phase::water) return b.viscosity;
  if (b.phase != Phase::water) return a.viscosity;
  const Real sum = a.viscosity + b.viscosity;
  return sum > Real(0) ? Real(2) * a.viscosity * b.viscosity / sum : Real(0);
}

template <int D, class P>
struct WaterViscosity {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false, only_adds = true;
  struct Sum {
    Vector<D, Real> friction{}, wall_friction{};
  };
  Real kernel_gradient_normalisation = Real(1);  // 1 / its slope on the lattice (lattice_sums.hpp)

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const Real mu = viscosity_between(*pair.medium_i, *pair.medium_j);
    if (!(mu > Real(0)) || !(pair.distance > Real(0))) return;
    const Real weight =
        Real(2) * kernel_gradient_normalisation * volume_of(particles, pair.i, *pair.medium_i) *
        pair_weight(volume_of(particles, pair.j, *pair.medium_j), pair.slope_per_distance);
    const auto drag = pair_drag(weight, mu, pair.velocity);
    sum.friction -= drag;
    if (pair.medium_j->phase == Phase::rigid) sum.wall_friction -= drag;
  }
  KERF_FUNCTION static Vector<D, Real> force(const Sum& sum) {
    return sum.friction - sum.wall_friction;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid) return;
    const Real inverse = Real(1) / medium.mass;
    particles.damping_acceleration[i] += inverse * sum.friction;
    particles.acceleration[i] += inverse * sum.friction;
    particles.repulsion[i] += inverse * sum.wall_friction;
  }
};

}  // namespace kerf
