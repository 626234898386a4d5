// SPDX-License-Identifier: Apache-2.0
// Velocity gradient over the particle's own phase, the sums in eqs. (30), (36) and (37) of
// Shinohara et al. (2004):  d v_a / d x_b = sum_j (m_j/rho_j) (v_j - v_i)_a d W_ij / d x_b. In a
// solid only intact particles of the same piece count: a strain against something that has broken
// away is no strain, and the shear force works over the same pairs.
#pragma once

#include "rates/pair.hpp"

namespace kerf {

template <int D, class P>
struct VelocityGradient {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Matrix<D, Real> gradient{};
  };

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!pair.cohesive) return;
    const Real volume = pair.medium_j->mass / particles.density(pair.j);
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b)
        sum.gradient(a, b) -= volume * pair.velocity[a] * pair.gradient[b];
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.velocity_gradient[i] = sum.gradient;
  }
};

}  // namespace kerf
