// SPDX-License-Identifier: Apache-2.0
// Absorb is the force of absorbing faces on solids (Lysmer & Kuhlemeyer, J. Eng. Mech. Div. ASCE 95
// (1969) 859): the traction of a plane wave that continues beyond a face with the normal n,
//   t = - rho c_p v_n n - rho c_s v_t,
// on the outermost particles. For faces along the axes each component of the velocity is damped at
// a rate of its own (simulation/absorbing_sites.hpp).
#pragma once

#include "parallel/ordered_sum.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D>
struct AbsorbingSite {
  Index particle;           // of the solid
  double mass;              // kg (2D: kg/m)
  Vector<D, double> rate;   // 1/s, along each axis
  Vector<D, double> force;  // N (2D: N/m), in the current step
};

// Applies the damping of the absorbing boundary to the acceleration of its particles.
// `velocity`: at the start of the step, m/s. That in its middle is extrapolated where a particle
// has a density (time/verlet.hpp), without this damping, and would make the face too stiff.
// `particle_of`: the index of each particle of the solid among all particles, or `no_particle`.
template <int D, class P>
struct Absorb {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const Vector<D, Real>* velocity;
  const Index* particle_of;
  Index no_particle;
  const std::uint8_t* detached;  // by particle of the solid
  AbsorbingSite<D>* sites;

  KERF_FUNCTION void operator()(Index k) const {
    AbsorbingSite<D>& site = sites[k];
    site.force = Vector<D, double>::zero();
    const Index i = particle_of[site.particle];
    if (i == no_particle || detached[site.particle] || particles.is_constrained(i)) return;
    if (particles.is_asleep(i)) return;
    Vector<D, Real> damping;
    for (int a = 0; a < D; ++a) damping[a] = Real(-site.rate[a]) * velocity[i][a];
    particles.acceleration[i] += damping;
    particles.damping_acceleration[i] += damping;
    site.force = site.mass * Vector<D, double>::from(damping);
  }
};

template <int D>
struct AbsorbingForce {
  const AbsorbingSite<D>* sites;
  KERF_FUNCTION void add(Index k, Terms<D>& sum) const {
    for (int a = 0; a < D; ++a) sum.value[a] += sites[k].force[a];
  }
};

}  // namespace kerf
