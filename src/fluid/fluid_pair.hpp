// SPDX-License-Identifier: Apache-2.0
// FluidPair solves the Riemann problem of a pair: between two fluids or two particles of one nearly
// incompressible solid the one of their line of centres, between fluid and anything else the one at
// a wall. Both particles of a pair get the same numbers, so that forces are equal and opposite.
#pragma once

#include <cmath>

#include "fluid/delta_sph.hpp"
#include "fluid/riemann.hpp"
#include "fluid/smooth_wall.hpp"
#include "fluid/water_viscosity.hpp"
#include "materials/equation_of_state.hpp"
#include "model/water_scheme.hpp"
#include "solid/pair_correction.hpp"

namespace kerf {

// `interior`: two fluids, or two particles of one nearly incompressible solid. `j_is_wall`: i is
// fluid, and j is solid or rigid.
enum class PairInteraction : std::uint8_t { nothing, interior, j_is_wall, i_is_wall };

template <int D, class P>
KERF_FUNCTION PairInteraction interaction_of(const ParticleView<D, P>& particles,
                                             const Pair<D, P>& pair) {
  const bool fluid_i = particles.is_fluid(pair.i), fluid_j = particles.is_fluid(pair.j);
  if (fluid_i && fluid_j) return PairInteraction::interior;
  if (fluid_i) return PairInteraction::j_is_wall;
  if (fluid_j) return PairInteraction::i_is_wall;
  return is_one_volume(particles, pair) ? PairInteraction::interior : PairInteraction::nothing;
}

// What a fluid particle and one of a smooth wall do to each other, on i, with the vector of
// fluid/smooth_wall.hpp in place of d_ij.
template <int D, class Real>
struct SmoothWallStar {
  Vector<D, Real> pressure;     // Pa m, P* times that vector
  Vector<D, Real> dissipation;  // Pa m, P_d times it
  Real parting;                 // m^2/s, in place of r (U* - U_i)
};

template <int D, class P>
struct FluidPair {
  using Real = typename P::Real;
  Vector<D, Real> gravity;                       // m/s^2
  Real kernel_gradient_normalisation = Real(1);  // 1 / its slope on the lattice (lattice_sums.hpp)
  PairCorrection<D, P> correction;               // where the spacing of a solid jumps
  WaterScheme scheme = WaterScheme::riemann;

  // Returns the factor of the kernel gradient of this pair.
  KERF_FUNCTION Real gradient_factor(const ParticleView<D, P>& particles,
                                     const Pair<D, P>& pair) const {
    return kernel_gradient_normalisation * correction(particles, pair);
  }

  // Returns the Riemann solution with particle i as the left state; U_i and U_j are along the line
  // of centres, positive from i to j.
  KERF_FUNCTION RiemannStar<Real> operator()(const ParticleView<D, P>& particles,
                                             const Pair<D, P>& pair, PairInteraction kind) const {
    const Real inverse = Real(1) / pair.distance;
    const Real u_i = -inverse * dot(particles.velocity[pair.i], pair.separation);
    const Real u_j = -inverse * dot(pair.of_j(particles.velocity[pair.j]), pair.separation);
    if (kind == PairInteraction::interior) {
      const auto left = side(particles, pair.i, *pair.medium_i, u_i);
      const auto right = side(particles, pair.j, *pair.medium_j, u_j);
      auto star = scheme == WaterScheme::delta_sph && pair.are_water()
                      ? DeltaSphPair::solve(left, right, inverse * pair.smoothing_length)
                      : solve_riemann(left, right, smoothing(pair, left, right));
      if (pair.are_water()) {
        const Real viscosity = viscosity_between(*pair.medium_i, *pair.medium_j);
        const Real rest = beyond_viscosity(magnitude(star.dissipation),
                                           magnitude(inverse * viscosity * (u_i - u_j)));
        star.dissipation = std::copysign(rest, star.dissipation);
      }
      return star;
    }
    const Real fall = dot(gravity, pair.separation);
    // The fluid is the left state; where it is j, e and with it both speeds change sign.
    const bool fluid_i = kind == PairInteraction::j_is_wall;
    const Index fluid = fluid_i ? pair.i : pair.j;
    const auto& medium = fluid_i ? *pair.medium_i : *pair.medium_j;
    const Real rise = (fluid_i ? Real(-1) : Real(1)) * particles.density(fluid) * fall;
    auto star = solve_riemann_at_wall(side(particles, fluid, medium, fluid_i ? u_i : -u_j),
                                      fluid_i ? u_j : -u_i, rise);
    const auto normal = wall_normal(particles, pair, kind);
    if (!(dot(normal, normal) > Real(0))) return star;
    // The speed is that towards the wall, not towards each of its particles, so that sliding along
    // the wall dissipates nothing.
    const Real into = (fluid_i ? Real(-1) : Real(1)) * dot(normal, pair.velocity);
    star.dissipation = wall_dissipation(side(particles, fluid, medium, into), into);
    return star;
  }

  // Returns what the two do to each other where one is of a smooth wall; `parting` is that of a
  // fluid particle i.
  KERF_FUNCTION SmoothWallStar<D, Real> at_smooth_wall(const ParticleView<D, P>& particles,
                                                       const Pair<D, P>& pair,
                                                       PairInteraction kind) const {
    if (!has_smooth_walls(particles)) return along_centres(particles, pair, kind);
    const bool fluid_i = kind == PairInteraction::j_is_wall;
    const auto both = WallPair<D, P>::of(particles, pair, fluid_i);
    const auto wall = smooth_wall_arm(particles, both);
    if (!wall.is_smooth) return along_centres(particles, pair, kind);
    const Real length = norm(wall.arm), parting = dot(wall.arm, both.velocity);
    if (!(length > Real(0))) return {wall.arm, wall.arm, Real(0)};
    const Index fluid = both.fluid;
    const Real hydrostatic = maximum(-dot(gravity, both.separation), Real(0));
    const Real rise =
        particles.density(fluid) * (hydrostatic - particles.wall_centripetal[fluid] * length);
    const auto& medium = fluid_i ? *pair.medium_i : *pair.medium_j;
    const auto star =
        solve_riemann_at_mirror(side(particles, fluid, medium, -parting / length), Real(0), rise);
    const Real factor = wall_force_factor(particles, fluid);
    const Real damping = Real(1) - room_at_wall(particles, fluid);
    const auto arm = (fluid_i ? Real(1) : Real(-1)) * wall.arm;
    return {(factor * star.mean_pressure) * arm, (factor * damping * star.dissipation) * arm,
            factor * (parting + pair.distance * star.speed)};
  }

  // Returns the direction along which P_d acts on i, m: d_ij between two fluids, beside a wall the
  // part of d_ij along its normal, as is the speed that is damped. So the dissipative force always
  // takes energy, however the two particles lie.
  KERF_FUNCTION Vector<D, Real> damped_direction(const ParticleView<D, P>& particles,
                                                 const Pair<D, P>& pair,
                                                 PairInteraction kind) const {
    if (kind == PairInteraction::interior) return pair.separation;
    const auto normal = wall_normal(particles, pair, kind);
    if (!(dot(normal, normal) > Real(0))) return pair.separation;
    const Real along = dot(pair.separation, normal);
    const bool is_repelled = kind == PairInteraction::j_is_wall ? along > Real(0) : along < Real(0);
    return (is_repelled ? along : Real(0)) * normal;
  }

 private:
  // The same in a corner.
  KERF_FUNCTION SmoothWallStar<D, Real> along_centres(const ParticleView<D, P>& particles,
                                                      const Pair<D, P>& pair,
                                                      PairInteraction kind) const {
    const auto star = (*this)(particles, pair, kind);
    const Real u_i = -dot(particles.velocity[pair.i], pair.separation) / pair.distance;
    return {star.mean_pressure * pair.separation,
            star.dissipation * damped_direction(particles, pair, kind),
            pair.distance * (star.speed - u_i)};
  }
  // Returns the normal of the wall beside the fluid of the two, into the fluid; zero where there is
  // none.
  KERF_FUNCTION static Vector<D, Real> wall_normal(const ParticleView<D, P>& particles,
                                                   const Pair<D, P>& pair, PairInteraction kind) {
    return kind == PairInteraction::j_is_wall ? particles.wall_normal[pair.i]
                                              : pair.of_j(particles.wall_normal[pair.j]);
  }
  // Weakly compressible matter has no strong shocks.
  KERF_FUNCTION static Real smoothing(const Pair<D, P>& pair, const RiemannSide<Real>& left,
                                      const RiemannSide<Real>& right) {
    const bool weak =
        is_weakly_compressible(*pair.medium_i) || is_weakly_compressible(*pair.medium_j);
    return weak ? Real(1) : shock_smoothing(left, right);
  }
  KERF_FUNCTION static RiemannSide<Real> side(const ParticleView<D, P>& particles, Index i,
                                              const Medium<Real>& medium, Real speed) {
    const Real sound_speed = impedance_speed_at(medium, particles.compression[i]);
    return {particles.density(i) * sound_speed, particles.pressure[i], speed, sound_speed};
  }
};

}  // namespace kerf
