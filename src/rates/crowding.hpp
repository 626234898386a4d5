// SPDX-License-Identifier: Apache-2.0
// Where a particle of water has more neighbours on one side than on the other,
//   C_i = sum_j V_0j nabla_i W_ij,  over all matter; 0 on a lattice and where neighbours are even,
// and whether one of its fluid neighbours was in a free surface at the end of the last step.
#pragma once

#include "rates/alike_sums.hpp"
#include "rates/pair.hpp"

namespace kerf {

template <int D, class Real>
struct Crowd {
  Vector<D, Real> gradient;  // 1/m, towards the crowd
  bool sees_surface;
};

template <int D, class P>
struct Crowding {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Vector<D, Real> gradient{};
    bool sees_surface = false;
  };
  Crowd<D, Real>* result;
  AlikeSums<D, Real> alike{};

  KERF_FUNCTION void start(const ParticleView<D, P>& particles, Index i, Sum& sum) const {
    if (!alike.are_known()) return;
    sum.gradient = alike[i].crowd();
    sum.sees_surface = particles.is_fluid(i) && alike[i].sees_surface > Real(0);
  }
  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    sum.gradient += pair.medium_j->volume * pair.gradient;
    sum.sees_surface |= particles.is_fluid(pair.j) && particles.has(pair.j, flag::surface);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>&, Index i, const Sum& sum) const {
    result[i] = {sum.gradient, sum.sees_surface};
  }
};

}  // namespace kerf
