// SPDX-License-Identifier: Apache-2.0
// Low-dissipation Riemann solution between two particles of water along their line of centres
// (Zhang, Hu & Adams, J. Comput. Phys. 335 (2017) 605). With e from j to i, the left state is i and
// the right one j, U = - v . e:
//   P* = (p_l + p_r) / 2 + beta rho c (U_l - U_r) / 2,
//   U* = (U_l + U_r) / 2 + (p_l - p_r) / (2 rho c),
//   beta = min(3 max(U_l - U_r, 0) / c, 1),   rho, c: means of both.
// beta switches the dissipation off where particles part or hardly move towards one another. The
// difference in pressure in U* diffuses density: it is what keeps the pressure smooth.
#pragma once

#include "rates/pair.hpp"

namespace kerf {

template <class T>
struct RiemannSide {
  T density;   // kg/m^3
  T pressure;  // Pa
  T speed;     // m/s, U: towards the other side is positive on the left
};

template <class T>
struct RiemannStar {
  T mean_pressure;  // Pa, the part that gives its work back
  T dissipation;    // Pa, the part that turns motion into heat; never negative
  T speed;          // m/s, U*
};

template <class T>
KERF_FUNCTION RiemannStar<T> solve_riemann(const RiemannSide<T>& left, const RiemannSide<T>& right,
                                           T sound_speed) {
  const T impedance = T(0.5) * (left.density + right.density) * sound_speed;
  const T approach = left.speed - right.speed;
  const T share = T(3) * approach / sound_speed;
  const T beta = share > T(1) ? T(1) : share;
  return {
      T(0.5) * (left.pressure + right.pressure),
      approach > T(0) ? T(0.5) * beta * impedance * approach : T(0),
      T(0.5) * (left.speed + right.speed) + T(0.5) * (left.pressure - right.pressure) / impedance};
}

// Water beside a wall, which may be rigid, or a solid that moves. The wall is the mirror of the
// water: the same density, the pressure of the water continued to the wall's place, a speed that
// makes the mean that of the wall. `hydrostatic`: rise of the pressure from the water to the wall.
// It is part of U*: without it the water above the floor would diffuse density upwards only, and
// its rows would sink together for as long as the run lasts.
template <class T>
KERF_FUNCTION RiemannStar<T> solve_riemann_at_wall(const RiemannSide<T>& water, T wall_speed,
                                                   T hydrostatic, T sound_speed) {
  const RiemannSide<T> mirror{water.density,
                              water.pressure + (hydrostatic > T(0) ? hydrostatic : T(0)),
                              T(2) * wall_speed - water.speed};
  return solve_riemann(water, mirror, sound_speed);
}

// Either of the two for a pair of which at least one is water, as its water sees it.
template <int D, class P>
struct WaterPair {
  using Real = typename P::Real;
  Vector<D, Real> gravity;  // m/s^2

  // As particle i sees it; U_i and U_j are along e from j to i. For i solid and j water the same
  // numbers result as for the pair the other way round, so that forces are equal and opposite.
  KERF_FUNCTION RiemannStar<Real> operator()(const ParticleView<D, P>& particles,
                                             const Pair<D, P>& pair) const {
    const Real inverse = Real(1) / pair.distance;
    const Real u_i = -inverse * dot(particles.velocity[pair.i], pair.separation);
    const Real u_j = -inverse * dot(particles.velocity[pair.j], pair.separation);
    const bool water_i = pair.medium_i->phase == Phase::water;
    const bool water_j = pair.medium_j->phase == Phase::water;
    if (water_i && water_j)
      return solve_riemann(side(particles, pair.i, u_i), side(particles, pair.j, u_j),
                           Real(0.5) * (pair.medium_i->sound_speed + pair.medium_j->sound_speed));
    const Real fall = dot(gravity, pair.separation);
    if (water_i)
      return solve_riemann_at_wall(side(particles, pair.i, u_i), u_j,
                                   -particles.density(pair.i) * fall, pair.medium_i->sound_speed);
    // Seen from the water, e and with it both speeds change sign.
    return solve_riemann_at_wall(side(particles, pair.j, -u_j), -u_i,
                                 particles.density(pair.j) * fall, pair.medium_j->sound_speed);
  }

 private:
  KERF_FUNCTION static RiemannSide<Real> side(const ParticleView<D, P>& particles, Index i,
                                              Real speed) {
    return {particles.density(i), particles.pressure[i], speed};
  }
};

}  // namespace kerf
