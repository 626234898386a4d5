// SPDX-License-Identifier: Apache-2.0
// DeltaSphPair is the pair interaction of water in delta-SPH (Antuono, Colagrossi, Marrone &
// Molteni, Comput. Phys. Commun. 181 (2010) 532), in the form of a Riemann solution
// (fluid/riemann.hpp), so that the same sums of force and continuity serve both: U* and P* are
// arithmetic means, and
//   P_d = alpha rho c h (U_l - U_r) / (2 r)
// is the artificial viscosity  m_i dv_i/dt = alpha rho_0 c h sum V_i V_j (v_ij . r_ij / r^2) nabla
// W, where particles part as well as where they approach. Its power is never negative.
#pragma once

#include "fluid/riemann.hpp"
#include "pairs/pair.hpp"

namespace kerf {

struct DeltaSphPair {
  static constexpr double viscosity = 0.02;  // alpha; Antuono et al.

  // `ratio`: h over the distance of the two.
  template <class T>
  KERF_FUNCTION static RiemannStar<T> solve(const RiemannSide<T>& left, const RiemannSide<T>& right,
                                            T ratio) {
    const T impedance = T(0.5) * (left.impedance + right.impedance);
    return {T(0.5) * (left.pressure + right.pressure),
            T(0.5 * viscosity) * impedance * ratio * (left.speed - right.speed),
            T(0.5) * (left.speed + right.speed)};
  }
};

// DensityDiffusion is the diffusion of density in delta-SPH (Antuono et al., Comput. Phys. Commun.
// 181 (2010) 532):
//   d rho_i/dt += delta h c sum_j V_j psi_ij . nabla_i W_ij,
//   psi_ij = 2 (rho_j - rho_i) r_ji / r^2 - <nabla rho>_i - <nabla rho>_j,
// between particles of water only. The corrected gradients (fluid/density_gradient.hpp) remove a
// linear density from it: the density of water at rest under gravity does not diffuse, at its
// surface neither.
template <int D, class P>
struct DensityDiffusion {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  static constexpr double strength = 0.1;  // delta; Antuono et al.
  struct Sum {
    Real diffused{};  // 1/s
  };
  const Vector<D, Real>* gradient;  // 1/m, of the relative density change

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!pair.are_water()) return;
    if (!(pair.distance > Real(0))) return;
    const Real rise = particles.compression[pair.j] - particles.compression[pair.i];
    const Real along = dot(pair.separation, pair.gradient);  // r_ij . nabla W, negative
    const Real straight = Real(-2) * rise * along / (pair.distance * pair.distance);
    const Real curved =
        straight - dot(gradient[pair.i] + pair.of_j(gradient[pair.j]), pair.gradient);
    const Real sound_speed = Real(0.5) * (pair.medium_i->sound_speed + pair.medium_j->sound_speed);
    sum.diffused += Real(strength) * pair.smoothing_length * sound_speed *
                    volume_of(particles, pair.j, *pair.medium_j) * curved;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.compression_rate[i] += sum.diffused;
  }
};

}  // namespace kerf
