// SPDX-License-Identifier: Apache-2.0
// ConcentrationGradientSum computes the concentration gradient of a water particle,
//   C_i = sum_j V_0j nabla_i W_ij   over all neighbours,
// which is 0 where neighbours are distributed evenly, as on a lattice, and whether one of its fluid
// neighbours was in a free surface at the end of the last step.
#pragma once

#include "fluid/known_sums.hpp"
#include "fluid/smooth_wall.hpp"
#include "pairs/pair.hpp"

namespace kerf {

template <int D, class Real>
struct ConcentrationGradient {
  Vector<D, Real> gradient;  // 1/m, towards the denser side
  bool near_free_surface;
};

template <int D, class P>
struct ConcentrationGradientSum {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Vector<D, Real> gradient{};
    bool near_free_surface = false;
  };
  ConcentrationGradient<D, Real>* result;
  KnownSums<D, Real> known{};

  KERF_FUNCTION void start(const ParticleView<D, P>& particles, Index i, Sum& sum) const {
    if (!known.are_known()) return;
    sum.gradient = known[i].concentration_gradient();
    sum.near_free_surface = particles.is_fluid(i) && known[i].near_free_surface > Real(0);
  }
  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (is_at_smooth_wall(particles, pair))
      sum.gradient -=
          (pair.medium_j->volume * wall_force_factor(particles, pair.i) * pair.slope_per_distance) *
          smooth_wall_arm(particles, pair).arm;
    else
      sum.gradient += pair.medium_j->volume * pair.gradient;
    sum.near_free_surface |= particles.is_fluid(pair.j) && particles.has(pair.j, flag::surface);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>&, Index i, const Sum& sum) const {
    result[i] = {sum.gradient, sum.near_free_surface};
  }
};

}  // namespace kerf
