// SPDX-License-Identifier: Apache-2.0
// Midpoint rule, eqs. (41) and (42) of Shinohara et al. (2004):
//   phi^(n+1/2) = phi^n + dt/2 F(phi^n),   phi^(n+1) = phi^n + dt F(phi^(n+1/2)).
#pragma once

#include "particles/prescribed_motion.hpp"
#include "shinohara2004/hooke_solid.hpp"

namespace kerf {

// Sets the state at the time `dt` after the start of the step, by the current rates.
template <int D, class P>
struct AdvanceFromStart {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const PrescribedMotion<D>* motions;
  double dt;  // s

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    if (particles.is_constrained(i)) {
      apply_prescribed_motion(particles, motions, i);
    } else if (medium.phase != Phase::rigid) {
      const auto travelled = dt * Vector<D, double>::from(particles.velocity[i]);
      particles.position[i] = particles.start_position[i] + travelled;
      particles.velocity[i] = particles.start_velocity[i] + Real(dt) * particles.acceleration[i];
    }
    if (medium.phase == Phase::rigid || particles.has(i, flag::upstream)) return;
    particles.compression[i] =
        particles.start_compression[i] + Real(dt) * particles.compression_rate[i];
    if (medium.phase == Phase::solid && !particles.fractured[i]) advance_shear(i, medium);
  }

 private:
  KERF_FUNCTION void advance_shear(Index i, const Medium<Real>& medium) const {
    auto rate = HookeSolid::shear_rate(medium, particles.shear[i], particles.velocity_gradient[i],
                                       particles.spin[i]);
    rate *= Real(dt);
    particles.shear[i] = particles.start_shear[i] + rate;
  }
};

}  // namespace kerf
