// SPDX-License-Identifier: Apache-2.0
// Where a particle of water has more neighbours on one side than on the other, and how near a free
// surface it is:
//   C_i = sum_j V_0j nabla_i W_ij,  over all matter; 0 on a lattice and where neighbours are even,
//   the least filling (rates/filling.hpp) of it and its fluid neighbours.
#pragma once

#include "rates/pair.hpp"

namespace kerf {

template <int D, class Real>
struct Crowd {
  Vector<D, Real> gradient;  // 1/m, towards the crowd
  Real least_filling;        // 1
};

template <int D, class P>
struct Crowding {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Vector<D, Real> gradient{};
    Real emptiest{2};
  };
  Crowd<D, Real>* result;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    sum.gradient += pair.medium_j->volume * pair.gradient;
    if (particles.is_fluid(pair.j) && particles.filling[pair.j] < sum.emptiest)
      sum.emptiest = particles.filling[pair.j];
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const Real own = particles.filling[i];
    result[i] = {sum.gradient, own < sum.emptiest ? own : sum.emptiest};
  }
};

}  // namespace kerf
