// SPDX-License-Identifier: Apache-2.0
// Moves particles of water from where they crowd to where they do not (Lind, Xu, Stansby & Rogers,
// J. Comput. Phys. 231 (2012) 1499, with the rate of Skillen et al., Comput. Methods Appl. Mech.
// Eng. 265 (2013) 163, made Galilean):
//   dr_i = - h^2 min(20 stir_i dt, 1/4) sum_j V_0j nabla_i W_ij,   stir_i = max |v_ij| / h over its
//   neighbours.
// The rate is ten times theirs, which is by the speed of the water instead of the differences: in a
// Taylor-Green vortex rows of particles are drawn apart as fast as they are (docs/theory).
// A shock does not count as stirring (rates/filling.hpp). Water that moves as one, such as a free
// jet, is not stirred and stays as it is to the last digit. Nothing is moved that is in a free
// surface or sees one (three rows), nor in a nozzle; at a wall particles are moved along it only.
// Velocities, densities and work stay as they are.
#pragma once

#include "rates/crowding.hpp"
#include "rates/filling.hpp"

namespace kerf {

template <int D, class P>
struct ShiftParticles {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const Crowd<D, Real>* crowd;            // null: nothing is shifted
  double dt;                              // s
  static constexpr double rate = 20.0;    // of `stir`
  static constexpr double most = 0.25;    // of h^2; more would take particles past one another
  static constexpr double longest = 0.1;  // of the spacing, in one step

  KERF_FUNCTION void operator()(Index i) const {
    if (crowd == nullptr) return;
    const auto& medium = particles.medium(i);
    if (medium.phase != Phase::water || particles.is_constrained(i)) return;
    if (crowd[i].sees_surface || particles.filling[i] < Real(whole_filling)) return;
    const Real h = medium.smoothing_length;
    const Real part = Real(rate * dt) * turning(particles, i);
    auto shift = (-(part < Real(most) ? part : Real(most)) * h * h) * crowd[i].gradient;
    const auto& wall = particles.wall_normal[i];
    shift -= dot(shift, wall) * wall;
    const Real length = norm(shift), limit = Real(longest) * medium.spacing;
    if (length > limit) shift = (limit / length) * shift;
    particles.position[i] += Vector<D, double>::from(shift);
  }
};

}  // namespace kerf
