// SPDX-License-Identifier: Apache-2.0
// ShiftParticles moves water particles down the concentration gradient (Lind, Xu, Stansby & Rogers,
// J. Comput. Phys. 231 (2012) 1499, with the rate of Skillen et al., Comput. Methods Appl. Mech.
// Eng. 265 (2013) 163 in a Galilean-invariant form):
//   dr_i = - h^2 min(20 s_i dt, 1/4) sum_j V_0j nabla_i W_ij,   s_i = max |v_ij| / h over
//   neighbours.
// The rate is ten times theirs, which depends on the speed of the water instead of the differences:
// in a Taylor-Green vortex rows of particles are drawn apart that fast (docs/theory). The part of a
// shock in s_i is left out (fluid/particle_concentration.hpp). Water in uniform motion, such as a
// free jet, is not shifted at all. Particles in or near a free surface (three rows) and in a nozzle
// are not shifted; at a wall particles are shifted along it only. Velocities, densities and work do
// not change.
#pragma once

#include "fluid/concentration_gradient.hpp"
#include "fluid/particle_concentration.hpp"

namespace kerf {

template <int D, class P>
struct ShiftParticles {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const ConcentrationGradient<D, Real>* concentration_gradient;  // null: nothing is shifted
  double dt;                                                     // s
  static constexpr double rate = 20.0;                           // of `max_relative_velocity`
  static constexpr double most = 0.25;    // of h^2; more would take particles past one another
  static constexpr double longest = 0.1;  // of the spacing, in one step

  KERF_FUNCTION void operator()(Index i) const {
    if (concentration_gradient == nullptr) return;
    const auto& medium = particles.medium(i);
    if (medium.phase != Phase::water || particles.is_constrained(i)) return;
    if (concentration_gradient[i].near_free_surface ||
        particles.kernel_sum[i] < Real(full_concentration))
      return;
    const Real h = medium.smoothing_length;
    const Real part = Real(rate * dt) * rearrangement_rate(particles, i);
    if (part == Real(0)) return;
    auto shift =
        (-(part < Real(most) ? part : Real(most)) * h * h) * concentration_gradient[i].gradient;
    const auto& wall = particles.wall_normal[i];
    shift -= dot(shift, wall) * wall;
    const Real length = norm(shift), limit = Real(longest) * medium.spacing;
    if (length > limit) shift = (limit / length) * shift;
    particles.position[i] += Vector<D, double>::from(shift);
  }
};

}  // namespace kerf
