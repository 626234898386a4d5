// SPDX-License-Identifier: Apache-2.0
// How two particles press on one another by their densities: two fluids, or two particles of one
// nearly incompressible solid, by the Riemann solution between them; fluid and anything else by
// that at a wall. Both particles of a pair get the same numbers, so that forces are equal and
// opposite.
#pragma once

#include <cmath>

#include "materials/equation_of_state.hpp"
#include "rates/central_water.hpp"
#include "rates/pair_fit.hpp"
#include "rates/riemann.hpp"
#include "rates/water_scheme.hpp"
#include "rates/water_viscosity.hpp"

namespace kerf {

// `alike`: two fluids, or two parts of one solid. `wall_of_i`: i is fluid, j what it meets.
enum class Meeting : std::uint8_t { nothing, alike, wall_of_i, wall_of_j };

template <int D, class P>
KERF_FUNCTION Meeting meeting(const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
  const bool fluid_i = particles.is_fluid(pair.i), fluid_j = particles.is_fluid(pair.j);
  if (fluid_i && fluid_j) return Meeting::alike;
  if (fluid_i) return Meeting::wall_of_i;
  if (fluid_j) return Meeting::wall_of_j;
  return is_one_volume(particles, pair) ? Meeting::alike : Meeting::nothing;
}

template <int D, class P>
struct FluidPair {
  using Real = typename P::Real;
  Vector<D, Real> gravity;    // m/s^2
  Real steepening = Real(1);  // of the kernel: 1 / its slope on the lattice (lattice_sums.hpp)
  PairFit<D, P> fit;          // where the spacing of a solid jumps
  WaterScheme scheme = WaterScheme::riemann;

  // By which the gradient of the kernel counts.
  KERF_FUNCTION Real steepness(const ParticleView<D, P>& particles, const Pair<D, P>& pair) const {
    return steepening * fit(particles, pair);
  }

  // As particle i sees it; U_i and U_j are along e from j to i.
  KERF_FUNCTION RiemannStar<Real> operator()(const ParticleView<D, P>& particles,
                                             const Pair<D, P>& pair, Meeting kind) const {
    const Real inverse = Real(1) / pair.distance;
    const Real u_i = -inverse * dot(particles.velocity[pair.i], pair.separation);
    const Real u_j = -inverse * dot(pair.of_j(particles.velocity[pair.j]), pair.separation);
    if (kind == Meeting::alike) {
      const auto left = side(particles, pair.i, *pair.medium_i, u_i);
      const auto right = side(particles, pair.j, *pair.medium_j, u_j);
      auto star = scheme == WaterScheme::delta_sph && pair.are_water()
                      ? CentralWater::solve(left, right, inverse * pair.smoothing_length)
                      : solve_riemann(left, right, smoothing(pair, left, right));
      if (pair.are_water())
        star.dissipation = beyond_viscosity(
            star.dissipation,
            inverse * viscosity_between(*pair.medium_i, *pair.medium_j) * (u_i - u_j));
      return star;
    }
    const Real fall = dot(gravity, pair.separation);
    // Seen from the fluid, e and with it both speeds change sign where j is the fluid.
    const bool fluid_i = kind == Meeting::wall_of_i;
    const Index fluid = fluid_i ? pair.i : pair.j;
    const auto& medium = fluid_i ? *pair.medium_i : *pair.medium_j;
    const Real rise = (fluid_i ? Real(-1) : Real(1)) * particles.density(fluid) * fall;
    auto star = solve_riemann_at_wall(side(particles, fluid, medium, fluid_i ? u_i : -u_j),
                                      fluid_i ? u_j : -u_i, rise);
    const auto normal = wall_normal(particles, pair, kind);
    if (!(dot(normal, normal) > Real(0))) return star;
    // Towards the wall, not towards each of its particles: sliding along it dissipates nothing.
    const Real into = (fluid_i ? Real(-1) : Real(1)) * dot(normal, pair.velocity);
    star.dissipation =
        solve_riemann_at_wall(side(particles, fluid, medium, into), Real(0), Real(0)).dissipation;
    return star;
  }

  // Of a push on i, the part along which the pair is damped: beside a wall along its normal, as the
  // speed that is damped, so that what is damped loses energy whichever way the two lie.
  KERF_FUNCTION Vector<D, Real> damped(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                                       Meeting kind, const Vector<D, Real>& push) const {
    if (kind == Meeting::alike) return push;
    const auto normal = wall_normal(particles, pair, kind);
    if (!(dot(normal, normal) > Real(0))) return push;
    const Real along = dot(push, normal);
    const bool parts = kind == Meeting::wall_of_i ? along > Real(0) : along < Real(0);
    return (parts ? along : Real(0)) * normal;
  }

 private:
  // Of the wall that the fluid of the two is at, into the fluid; zero where it is at none.
  KERF_FUNCTION static Vector<D, Real> wall_normal(const ParticleView<D, P>& particles,
                                                   const Pair<D, P>& pair, Meeting kind) {
    return kind == Meeting::wall_of_i ? particles.wall_normal[pair.i]
                                      : pair.of_j(particles.wall_normal[pair.j]);
  }
  // Tait's matter is hardly compressed and has no strong shocks.
  KERF_FUNCTION static Real smoothing(const Pair<D, P>& pair, const RiemannSide<Real>& left,
                                      const RiemannSide<Real>& right) {
    const bool weak = pair.medium_i->equation_of_state == EquationOfState::tait ||
                      pair.medium_j->equation_of_state == EquationOfState::tait;
    return weak ? Real(1) : shock_smoothing(left, right);
  }
  KERF_FUNCTION static RiemannSide<Real> side(const ParticleView<D, P>& particles, Index i,
                                              const Medium<Real>& medium, Real speed) {
    const Real sound = impedance_speed_at(medium, particles.compression[i]);
    return {particles.density(i) * sound, particles.pressure[i], speed, sound};
  }
};

}  // namespace kerf
