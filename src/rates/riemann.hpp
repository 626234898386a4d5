// SPDX-License-Identifier: Apache-2.0
// Low-dissipation Riemann solution between two fluid particles along their line of centres (Zhang,
// Hu & Adams, J. Comput. Phys. 335 (2017) 605). With e from j to i, the left state is i and the
// right one j, U = - v . e, and Z = rho c the impedance of a side (acoustic solution: Toro, Riemann
// Solvers and Numerical Methods for Fluid Dynamics, 3rd ed. (2009), section 9.3):
//   P* = (Z_r p_l + Z_l p_r) / (Z_l + Z_r) + beta Z_l Z_r (U_l - U_r) / (Z_l + Z_r),
//   U* = (Z_l U_l + Z_r U_r + p_l - p_r) / (Z_l + Z_r),
//   beta = min(3 max(U_l - U_r, 0) / c, 1),   c: the lesser of both.
// beta switches the dissipation off where particles part or hardly move towards one another. The
// difference in pressure in U* diffuses density: it is what keeps the pressure smooth.
#pragma once

#include "rates/pair.hpp"

namespace kerf {

template <class T>
struct RiemannSide {
  T density;      // kg/m^3
  T pressure;     // Pa
  T speed;        // m/s, U: towards the other side is positive on the left
  T sound_speed;  // m/s
};

template <class T>
struct RiemannStar {
  T mean_pressure;  // Pa, the part that gives its work back
  T dissipation;    // Pa, the part that turns motion into heat; never negative
  T speed;          // m/s, U*
};

// `sharpness`: U* takes the share 1 - sharpness (U_l - U_r) / c of the difference in pressure. In a
// strong shock that difference is the shock's own, not noise: density that it puts ahead of the
// front is squeezed once more there and is missing behind. 0 for weakly compressible matter.
template <class T>
KERF_FUNCTION RiemannStar<T> solve_riemann(const RiemannSide<T>& left, const RiemannSide<T>& right,
                                           T sharpness = T(0)) {
  const T z_left = left.density * left.sound_speed;
  const T z_right = right.density * right.sound_speed;
  const T inverse = T(1) / (z_left + z_right);
  const T share_left = z_left * inverse, share_right = z_right * inverse;
  const T approach = left.speed - right.speed;
  const T slower = left.sound_speed < right.sound_speed ? left.sound_speed : right.sound_speed;
  const T strength = T(3) * approach / slower;
  const T beta = strength > T(1) ? T(1) : strength;
  T smoothing = T(1);
  if (approach > T(0)) smoothing -= sharpness * approach / slower;
  return {share_right * left.pressure + share_left * right.pressure,
          approach > T(0) ? beta * share_left * z_right * approach : T(0),
          share_left * left.speed + share_right * right.speed +
              (smoothing > T(0) ? smoothing : T(0)) * (left.pressure - right.pressure) * inverse};
}

// Fluid beside a wall, which may be rigid, or a solid that moves. The wall is the mirror of the
// fluid: the same density, the pressure of the fluid continued to the wall's place, a speed that
// makes the mean that of the wall. `hydrostatic`: rise of the pressure from the fluid to the wall.
// It is part of U*: without it the water above the floor would diffuse density upwards only, and
// its rows would sink together for as long as the run lasts.
template <class T>
KERF_FUNCTION RiemannStar<T> solve_riemann_at_wall(const RiemannSide<T>& fluid, T wall_speed,
                                                   T hydrostatic) {
  const RiemannSide<T> mirror{fluid.density,
                              fluid.pressure + (hydrostatic > T(0) ? hydrostatic : T(0)),
                              T(2) * wall_speed - fluid.speed, fluid.sound_speed};
  return solve_riemann(fluid, mirror);
}

}  // namespace kerf
