// SPDX-License-Identifier: Apache-2.0
// Velocity gradient over the particle's own phase, the sums in eqs. (30), (36) and (37) of
// Shinohara et al. (2004):  L_ab = d v_a / d x_b = sum_j (m_j/rho_j) (v_j - v_i)_a d W_ij / d x_b.
// In a solid the sums are over intact particles of the same piece, which are those that the shear
// force acts between.
//
// The spin of eq. (37), by which the Jaumann rate turns the stress, is the skew part of L M^-1 with
//   M_ab = sum_j (m_j/rho_j) (r_j - r_i)_a d W_ij / d x_b,
// exact for a rigid rotation wherever the neighbours are (Randles & Libersky 1996). The plain sum
// is not: on a lattice it is 0.7% too large, and after a turn the stress would lie 5 degrees ahead
// of its body. The strain rate (36) stays plain, because the shear force does its work on that one.
#pragma once

#include "pairs/pair.hpp"

namespace kerf {

template <int D, class P>
struct VelocityGradient {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  // M is 1 within a solid and about 1/2 at a free surface. A particle with one or two neighbours,
  // whose M is less than this in some direction, keeps the plain sum.
  static constexpr Real least_moment = Real(0.1);
  struct Sum {
    Matrix<D, Real> gradient{};
    Matrix<D, Real> moment{};
  };

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!pair.cohesive) return;
    const Real volume = pair.medium_j->mass / particles.density(pair.j);
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) {
        sum.gradient(a, b) -= volume * pair.velocity[a] * pair.gradient[b];
        sum.moment(a, b) -= volume * pair.separation[a] * pair.gradient[b];
      }
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.velocity_gradient[i] = sum.gradient;
    if (particles.medium(i).phase != Phase::solid) return;
    Matrix<D, Real> normalised = sum.gradient;
    divide(normalised, sum.moment, least_moment);
    particles.spin[i] = SkewTensor<D, Real>::part_of(normalised);
  }
};

}  // namespace kerf
