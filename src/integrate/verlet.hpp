// SPDX-License-Identifier: Apache-2.0
// The step of the `standard` formulation. Places go by position Verlet (drift, kick, drift); what
// forces and rates depend on besides is taken to the middle of the step by the rates of the last
// one (as the method of Adams and Bashforth does, of second order), so that one walk over the
// neighbours is enough:
//   x' = x^n + dt/2 v^n,   v' = v^n + dt/2 a_last,   rho' = rho^n + dt/2 (d rho/dt)_last,
// (v' of what has a density; of other solids v^n serves, which only damp by it),
//   a, d rho/dt  at (x', v', rho'),
//   v^(n+1) = v^n + dt a,   x^(n+1) = x' + dt/2 v^(n+1),   rho^(n+1) = rho^n + dt d rho/dt.
// For forces that depend on places only it keeps a nearby energy for ever (it is symplectic).
#pragma once

#include "integrate/follow_drive.hpp"
#include "rates/filling.hpp"

namespace kerf {

// Matter without pressure opens to twice its volume in the sums and no further: the drops of a
// spray are as dense as ever, and stand for no more room than that.
template <class T>
KERF_FUNCTION T opened_at_most(T compression) {
  return compression < T(-0.5) ? T(-0.5) : compression;
}

// To the middle of the step; the state of its start must be kept already.
template <int D, class P>
struct DriftHalf {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const Drive<D>* drives;  // over the first half
  double dt;               // s, of the whole step

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.is_constrained(i)) {
      follow_drive(particles, drives, i);
    } else if (particles.medium(i).phase != Phase::rigid) {
      particles.position[i] =
          particles.start_position[i] + 0.5 * dt * Vector<D, double>::from(particles.velocity[i]);
      if (particles.has_density(i))
        particles.velocity[i] += Real(0.5 * dt) * particles.last_acceleration[i];
    }
    if (!particles.has_density(i) || particles.has(i, flag::upstream)) return;
    particles.compression[i] = opened_at_most(particles.start_compression[i] +
                                              Real(0.5 * dt) * particles.compression_rate[i]);
  }
};

// The kick and the second half drift. What the forces did over the step is known only now: work is
// force times the way gone, to the last digit.
template <int D, class P>
struct KickAndDrift {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const Drive<D>* drives;  // over the whole step
  double dt;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid && !particles.is_constrained(i)) return;
    if (particles.is_constrained(i)) {
      follow_drive(particles, drives, i);
    } else {
      particles.velocity[i] = particles.start_velocity[i] + Real(dt) * particles.acceleration[i];
      particles.last_acceleration[i] = particles.acceleration[i];
      particles.position[i] += 0.5 * dt * Vector<D, double>::from(particles.velocity[i]);
    }
    const auto moved = Vector<D, Real>::from(particles.position[i] - particles.start_position[i]);
    const Real rate = Real(-1) / Real(dt);
    particles.pressure_power[i] = rate * dot(particles.pressure_acceleration[i], moved);
    particles.artificial_power[i] = rate * dot(particles.damping_acceleration[i], moved);
  }
};

// What the walk over the neighbours found of walls and free surfaces holds until the next one.
template <int D, class P>
struct KeepSurroundings {
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    particles.wall_normal[i] = particles.next_wall_normal[i];
    const bool open = particles.filling[i] < typename P::Real(whole_filling);
    const int others = particles.flags[i] & ~flag::surface;
    particles.flags[i] = static_cast<std::uint8_t>(open ? others | flag::surface : others);
  }
};

// Density to the end of the step; opened matter is no emptier than the room that it is in
// (rates/filling.hpp).
template <int D, class P>
struct CloseDensity {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  double dt;

  KERF_FUNCTION void operator()(Index i) const {
    if (!particles.has_density(i) || particles.has(i, flag::upstream)) return;
    const Real compression =
        opened_at_most(particles.start_compression[i] + Real(dt) * particles.compression_rate[i]);
    const Real least = particles.filling[i] < Real(1) ? particles.filling[i] - Real(1) : Real(0);
    particles.compression[i] = compression < least ? least : compression;
  }
};

}  // namespace kerf
