// SPDX-License-Identifier: Apache-2.0
// How full the room around a particle is:  phi_i = sum_j V_0j W_ij,  itself among them; 1 inside
// matter that is neither squeezed nor opened, about 1/2 at a flat surface. The continuity equation
// adds up rates along the way and has no memory of where particles are: matter that was torn about
// without pressure may stay "opened" although its particles have closed in again, and would let
// others into it. So the density of opened matter is not below rho_0 phi (integrate/verlet.hpp).
#pragma once

#include "rates/pair.hpp"

namespace kerf {

template <int D, class P, class Kernel>
struct Filling {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Real filling{};
  };

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!particles.has_density(pair.i)) return;
    sum.filling += pair.medium_j->volume * Kernel::value(pair.distance, pair.smoothing_length);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    particles.filling[i] =
        sum.filling + medium.volume * Kernel::value(Real(0), Real(medium.smoothing_length));
  }
};

}  // namespace kerf
