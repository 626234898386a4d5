// SPDX-License-Identifier: Apache-2.0
// Continuity, eq. (22) of Shinohara et al. (2004), over water and solid together, which is what
// makes the impact pressure:  d rho_i/dt = sum_j m_j (v_i - v_j) . nabla_i W_ij. Kept as the rate
// of compression rho/rho_0 - 1.
#pragma once

#include "pairs/pair.hpp"

namespace kerf {

template <int D, class P>
struct Continuity {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Real density_rate{};
  };

  KERF_FUNCTION void add(const ParticleView<D, P>&, const Pair<D, P>& pair, Sum& sum) const {
    sum.density_rate += pair.medium_j->mass * dot(pair.velocity, pair.gradient);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.compression_rate[i] = sum.density_rate / particles.medium(i).density;
  }
};

}  // namespace kerf
