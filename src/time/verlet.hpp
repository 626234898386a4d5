// SPDX-License-Identifier: Apache-2.0
// The step of the `standard` formulation is position Verlet (drift, kick, drift). The density of a
// fluid is that of the middle of the step, half a step ahead of its velocity, as in a leapfrog; the
// velocity at the end of the step, by which it changes, is extrapolated by the last forces without
// the dissipative ones, so that one pair loop per step is enough:
//   x' = x^n + dt/2 v^n,   v' = v^n + dt (a - a_dissipative)_last,
// (v' of particles with a density; other solids, on which v acts by damping only, keep v^n),
//   a, d rho/dt  at (x', v', rho^n),
//   v^(n+1) = v^n + dt a,   x^(n+1) = x' + dt/2 v^(n+1),   rho^(n+1) = rho^n + dt d rho/dt.
// For forces that depend on positions only the scheme is symplectic: its energy error stays
// bounded. docs/theory/verlet.md has its stability.
#pragma once

#include "fluid/particle_concentration.hpp"
#include "particles/prescribed_motion.hpp"

namespace kerf {

// Matter without pressure expands to at most twice its volume in the sums: the drops of a spray
// keep their density, and a particle represents no more volume than that.
template <class T>
KERF_FUNCTION T limit_expansion(T compression) {
  return compression < T(-0.5) ? T(-0.5) : compression;
}

// Moves a particle to the middle of the step, and extrapolates the velocity of one with a density
// to its end; SaveStepStart must have recorded the start.
template <int D, class P>
struct DriftHalf {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const PrescribedMotion<D>* motions;  // over the first half
  double dt;                           // s, of the full step

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.is_constrained(i)) {
      apply_prescribed_motion(particles, motions, i);
    } else if (particles.medium(i).phase != Phase::rigid) {
      particles.position[i] =
          particles.start_position[i] + 0.5 * dt * Vector<D, double>::from(particles.velocity[i]);
      if (particles.has_density(i))
        particles.velocity[i] += Real(dt) * particles.conservative_acceleration[i];
    }
  }
};

// The kick and the second half of the drift. The work of the forces over the step is force times
// displacement, so that the balance of energy closes to rounding.
template <int D, class P>
struct KickAndDrift {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const PrescribedMotion<D>* motions;  // over the full step
  double dt;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid && !particles.is_constrained(i)) return;
    if (particles.is_constrained(i)) {
      apply_prescribed_motion(particles, motions, i);
    } else {
      particles.velocity[i] = particles.start_velocity[i] + Real(dt) * particles.acceleration[i];
      particles.conservative_acceleration[i] =
          particles.acceleration[i] - particles.damping_acceleration[i];
      particles.position[i] += 0.5 * dt * Vector<D, double>::from(particles.velocity[i]);
    }
    const auto moved = Vector<D, Real>::from(particles.position[i] - particles.start_position[i]);
    particles.pressure_power[i] =
        Real(-1) / Real(dt) * dot(particles.pressure_acceleration[i], moved);
    // Rigid bodies that move do a part of the work against their pressure.
    if (particles.rigid_power != nullptr)
      particles.pressure_power[i] += particles.rigid_power[i].pressure;
  }
};

// Takes over the wall normals, the smooth walls and the free-surface flags that the pair loop
// found.
template <int D, class P>
struct UpdateSurfaceFlags {
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    particles.wall_normal[i] = particles.next_wall_normal[i];
    const bool open = particles.kernel_sum[i] < typename P::Real(full_concentration);
    int flags = particles.flags[i] & ~flag::surface;
    if (open) flags |= flag::surface;
    if (particles.next_smooth_wall != nullptr && particles.is_fluid(i)) {
      const auto& wall = particles.next_smooth_wall[i];
      particles.face_normal[i] = wall.normal;
      particles.wall_force_excess[i] = wall.force_excess;
      particles.wall_volume_excess[i] = wall.volume_excess;
      particles.wall_room[i] = wall.room;
      particles.wall_centripetal[i] = wall.centripetal;
      flags &= ~(flag::in_corner | flag::at_edge);
      if (wall.is_corner) flags |= flag::in_corner;
      if (wall.is_edge) flags |= flag::at_edge;
    }
    particles.flags[i] = static_cast<std::uint8_t>(flags);
  }
};

// Integrates the density to the end of the step. The density of matter that opens as it expands is
// at least that of its particle concentration (fluid/particle_concentration.hpp).
template <int D, class P>
struct FinalizeDensity {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  double dt;

  KERF_FUNCTION void operator()(Index i) const {
    if (!particles.has_density(i) || particles.has(i, flag::upstream)) return;
    const Real compression =
        limit_expansion(particles.start_compression[i] + Real(dt) * particles.compression_rate[i]);
    const Real least =
        particles.kernel_sum[i] < Real(1) ? particles.kernel_sum[i] - Real(1) : Real(0);
    const bool opens = compression < least && !particles.bears_tension(i);
    particles.compression[i] = opens ? least : compression;
  }
};

}  // namespace kerf
