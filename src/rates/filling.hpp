// SPDX-License-Identifier: Apache-2.0
// How full the room around a particle is:  phi_i = sum_j V_0j W_ij,  itself among them; 1 inside
// matter that is neither squeezed nor opened, about 1/2 at a flat surface. The continuity equation
// adds up rates along the way and has no memory of where particles are: matter that was torn about
// without pressure may stay "opened" although its particles have closed in again, and would let
// others into it. So the density of opened matter is not below rho_0 phi (integrate/verlet.hpp),
// and that of water in motion goes back to it (integrate/regain_density.hpp). Matter of another
// phase that is squeezed takes the room that its density leaves it, V_0j rho_0j / rho_j: where
// water is driven into crushed foam it is the foam that gives way. How fast matter is stirred is
// the largest |v_ij| of its fluid neighbours over h.
#pragma once

#include <cmath>

#include "rates/alike_sums.hpp"
#include "rates/pair.hpp"

namespace kerf {

// Above it a particle lacks no neighbours: it is not in a free surface.
inline constexpr double whole_filling = 0.95;

// How fast the neighbours of a particle of water change places, 1/s: its `stir`, less what a shock
// does to it. There neighbours move past one another by being squeezed: with the speed u' = - div v
// of a plane wave they do so at up to 2 u' over h.
template <int D, class P>
KERF_FUNCTION typename P::Real turning(const ParticleView<D, P>& particles, Index i) {
  using Real = typename P::Real;
  if (particles.medium(i).equation_of_state == EquationOfState::tait) return particles.stir[i];
  const Real squeeze = particles.compression_rate[i] / (Real(1) + particles.compression[i]);
  const Real turned = particles.stir[i] - Real(2) * std::abs(squeeze);
  return turned > Real(0) ? turned : Real(0);
}

template <int D, class P, class Kernel>
struct Filling {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Real filling{};
    Real fastest_squared{};  // m^2/s^2
  };
  AlikeSums<D, Real> alike{};

  KERF_FUNCTION void start(const ParticleView<D, P>& particles, Index i, Sum& sum) const {
    if (!alike.are_known()) return;
    sum.filling = alike[i].filling();
    if (particles.is_fluid(i)) sum.fastest_squared = alike[i].fastest_squared;
  }
  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!particles.has_density(pair.i)) return;
    sum.filling += room(particles, pair) * Kernel::value(pair.distance, pair.smoothing_length);
    if (!particles.is_fluid(pair.j)) return;
    const Real squared = dot(pair.velocity, pair.velocity);
    if (squared > sum.fastest_squared) sum.fastest_squared = squared;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    particles.filling[i] =
        sum.filling + medium.volume * Kernel::value(Real(0), Real(medium.smoothing_length));
    particles.stir[i] = std::sqrt(sum.fastest_squared) / medium.smoothing_length;
  }

 private:
  KERF_FUNCTION static Real room(const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
    const Real at_rest = pair.medium_j->volume;
    if (pair.medium_i->phase == pair.medium_j->phase) return at_rest;
    const Real now = volume_of(particles, pair.j, *pair.medium_j);
    return now < at_rest ? now : at_rest;
  }
};

}  // namespace kerf
