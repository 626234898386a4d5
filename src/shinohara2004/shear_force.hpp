// SPDX-License-Identifier: Apache-2.0
// Stress part of the momentum equation (26) of Shinohara et al. (2004) besides pressure: viscous
// stress among water, deviatoric stress within intact solid,
//   dv_i/dt = sum_j m_j (s_i + s_j) / (rho_i rho_j) . nabla_i W_ij.
#pragma once

#include "pairs/pair.hpp"

namespace kerf {

template <int D, class P>
struct ShearForce {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Vector<D, Real> shear{};
  };

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!pair.cohesive) return;
    const auto stress = particles.shear[pair.i] + particles.shear[pair.j];
    const Real density_product = particles.density(pair.i) * particles.density(pair.j);
    sum.shear += (pair.medium_j->mass / density_product) * (stress * pair.gradient);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.acceleration[i] += sum.shear;
  }
};

}  // namespace kerf
