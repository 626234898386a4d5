// SPDX-License-Identifier: Apache-2.0
// Who leaves at the end of a step: water that has passed its nozzle's exit is released, particles
// outside the domain and, where the case says so, water flowing back towards its nozzle (Fig. 7 of
// Shinohara et al. 2004) are marked for removal.
#pragma once

#include "integrate/drive.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct MarkLeavers {
  ParticleView<D, P> particles;
  const Drive<D>* drives;
  Vector<D, double> minimum, maximum;  // m, the domain

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.medium(i).phase == Phase::rigid) return;
    const Drive<D>& drive = drives[particles.source[i]];
    const auto& x = particles.position[i];
    if (particles.has(i, flag::upstream)) {
      if (dot(x - drive.exit, drive.direction) > 0.0)
        particles.flags[i] = static_cast<std::uint8_t>(particles.flags[i] & ~flag::upstream);
      return;
    }
    // A place that is no number is not outside: the time step finds it and stops the run.
    bool inside = true;
    for (int a = 0; a < D; ++a) inside = inside && !(x[a] < minimum[a]) && !(x[a] > maximum[a]);
    const auto velocity = Vector<D, double>::from(particles.velocity[i]);
    if (!inside)
      particles.flags[i] |= flag::outside;
    else if (drive.erases && dot(velocity, drive.direction) < drive.erase_speed)
      particles.flags[i] |= flag::erased;
  }
};

template <int D, class P>
struct HasFlag {
  ParticleView<D, P> particles;
  std::uint8_t flags;  // any of them
  KERF_FUNCTION bool operator()(Index i) const { return particles.has(i, flags); }
};

}  // namespace kerf
