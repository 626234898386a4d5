// SPDX-License-Identifier: Apache-2.0
// WaterViscosity is the viscosity of water (Morris, Fox & Zhu, J. Comput. Phys. 136 (1997) 214),
// for constant mu:
//   m_i dv_i/dt = sum_j V_i V_j 2 mu v_ij / r_ij dW/dr,   mu: that of the water of the pair,
// with the kernel gradient normalised as for pressures: on a lattice the sum is short by the same
// slope. At walls and solids the water has their velocity (no slip). Where the face of a wall
// particle is known, at the distance s_i from the water and the depth below which the particle
// lies, its velocity is that of a linear profile through the surface (Morris et al.):
//   v_ij becomes f_i v_ij (d_ij . n_j) / max(s_i, d / 4),
// with the factor f_i of fluid/smooth_wall.hpp, since the sum over the wall is that of its
// pressure.
#pragma once

#include "fluid/pair_terms.hpp"
#include "fluid/smooth_wall.hpp"
#include "pairs/pair.hpp"

namespace kerf {

// Returns mu between two media, one of which is water, Pa s: the harmonic mean of two waters.
template <class Real>
KERF_FUNCTION Real viscosity_between(const Medium<Real>& a, const Medium<Real>& b) {
  if (a.phase != Phase::water) return b.viscosity;
  if (b.phase != Phase::water) return a.viscosity;
  const Real sum = a.viscosity + b.viscosity;
  return sum > Real(0) ? Real(2) * a.viscosity * b.viscosity / sum : Real(0);
}

// Returns by how much a particle of a wall drags at fluid more than its own velocity would, 1 where
// its face is not known.
template <int D, class P>
KERF_FUNCTION typename P::Real no_slip_factor(const ParticleView<D, P>& particles,
                                              const Pair<D, P>& pair) {
  using Real = typename P::Real;
  const bool fluid_i = particles.is_fluid(pair.i);
  if (!has_smooth_walls(particles) || (fluid_i && particles.is_fluid(pair.j))) return Real(1);
  const auto& of_wall = fluid_i ? *pair.medium_j : *pair.medium_i;
  const auto& of_fluid = fluid_i ? *pair.medium_i : *pair.medium_j;
  const auto between = WallPair<D, P>::of(particles, pair, fluid_i);
  if (!is_smooth_wall(particles, between.wall, of_wall, of_fluid)) return Real(1);
  const Real along = dot(between.separation, between.of_face);
  const Real height = along - particles.face_depth[between.wall];
  if (!(height > Real(0))) return Real(1);
  return wall_force_factor(particles, between.fluid) * along /
         maximum(height, Real(0.25) * Real(of_wall.spacing));
}

template <int D, class P>
struct WaterViscosity {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false, only_adds = true;
  struct Sum {
    Vector<D, Real> friction{}, wall_friction{};
  };
  Real kernel_gradient_normalisation = Real(1);  // 1 / its slope on the lattice (lattice_sums.hpp)

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const Real mu = viscosity_between(*pair.medium_i, *pair.medium_j);
    if (!(mu > Real(0)) || !(pair.distance > Real(0))) return;
    const Real weight =
        Real(2) * kernel_gradient_normalisation * volume_of(particles, pair.i, *pair.medium_i) *
        pair_weight(volume_of(particles, pair.j, *pair.medium_j), pair.slope_per_distance);
    const auto drag = pair_drag(weight * no_slip_factor(particles, pair), mu, pair.velocity);
    sum.friction -= drag;
    if (pair.medium_j->phase == Phase::rigid) sum.wall_friction -= drag;
  }
  KERF_FUNCTION static Vector<D, Real> force(const Sum& sum) {
    return sum.friction - sum.wall_friction;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid) return;
    const Real inverse = Real(1) / medium.mass;
    particles.damping_acceleration[i] += inverse * sum.friction;
    particles.acceleration[i] += inverse * sum.friction;
    particles.repulsion[i] += inverse * sum.wall_friction;
  }
};

}  // namespace kerf
