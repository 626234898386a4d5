// SPDX-License-Identifier: Apache-2.0
// This functor marks outflow at the end of a step: water that has passed the exit of its nozzle is
// released; particles outside the domain and, on request, water that flows back towards
// its nozzle (Fig. 7 of Shinohara et al. 2004) are marked for removal.
#pragma once

#include "particles/prescribed_motion.hpp"

namespace kerf {

template <int D, class P>
struct MarkOutflow {
  ParticleView<D, P> particles;
  const PrescribedMotion<D>* motions;
  Vector<D, double> minimum, maximum;  // m, the domain

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.medium(i).phase == Phase::rigid) return;
    const PrescribedMotion<D>& motion = motions[particles.source[i]];
    const auto& x = particles.position[i];
    if (particles.has(i, flag::upstream)) {
      if (dot(x - motion.exit, motion.direction) > 0.0)
        particles.flags[i] = static_cast<std::uint8_t>(particles.flags[i] & ~flag::upstream);
      return;
    }
    // A position that is not a number is not outside: the time step finds it and stops the run.
    bool inside = true;
    for (int a = 0; a < D; ++a) inside = inside && !(x[a] < minimum[a]) && !(x[a] > maximum[a]);
    const auto velocity = Vector<D, double>::from(particles.velocity[i]);
    if (!inside)
      particles.flags[i] |= flag::outside;
    else if (motion.removes_back_flow &&
             dot(velocity, motion.direction) < motion.back_flow_removal_speed)
      particles.flags[i] |= flag::erased;
  }
};

template <int D, class P>
struct HasFlag {
  ParticleView<D, P> particles;
  std::uint8_t flags;  // one of them suffices
  KERF_FUNCTION bool operator()(Index i) const { return particles.has(i, flags); }
};

}  // namespace kerf
