// SPDX-License-Identifier: Apache-2.0
// DensityGradient computes the gradient of the density of water over its own particles. It is exact
// for a linear field also where neighbours are lacking (Randles & Libersky, Comput. Methods Appl.
// Mech. Eng. 139 (1996) 375):
//   <nabla rho>_i = L_i sum_j V_j (rho_j - rho_i) nabla_i W_ij,
//   L_i = [sum_j V_j r_ji (x) nabla_i W_ij]^-1,
// in units of rho_0. Where the neighbours span no volume (a drop, a thread) it is zero.
#pragma once

#include "materials/push_forward.hpp"
#include "pairs/pair.hpp"

namespace kerf {

template <int D, class P>
struct DensityGradient {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  // Of the sum in brackets, whose determinant is 1 inside and some hundredths in a corner of a
  // block.
  static constexpr double least_determinant = 1e-3;
  struct Sum {
    Vector<D, Real> gradient{};
    Matrix<D, Real> spread = Matrix<D, Real>::zero();
  };
  Vector<D, Real>* result;  // 1/m

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!pair.are_water()) return;
    const Real volume = volume_of(particles, pair.j, *pair.medium_j);
    const Real rise = particles.compression[pair.j] - particles.compression[pair.i];
    sum.gradient += (volume * rise) * pair.gradient;
    add_outer(sum.spread, -volume * pair.separation, pair.gradient);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>&, Index i, const Sum& sum) const {
    const Real size = determinant(sum.spread);
    result[i] = size > Real(least_determinant) ? inverse(sum.spread) * sum.gradient
                                               : Vector<D, Real>::zero();
  }
};

}  // namespace kerf
