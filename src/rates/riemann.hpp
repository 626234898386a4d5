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

#include "core/select.hpp"

namespace kerf {

template <class T>
struct RiemannSide {
  T impedance;    // kg/(m^2 s), Z = rho c
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

// By how much of the lesser speed of sound the two approach; 0 where they part.
template <class T>
KERF_FUNCTION T approach_of(const RiemannSide<T>& left, const RiemannSide<T>& right) {
  return maximum(left.speed - right.speed, T(0)) *
         reciprocal(minimum(left.sound_speed, right.sound_speed));
}

// The same beside a particle of a fluid whose speed of sound is c everywhere, so that Z = m c / V,
// without what the parts share:
//   P* = (V_l p_l + V_r p_r + U D) / (V_l + V_r),   U = max(- U_r, 0),   D = m min(3 U, c),
//   U* = V_l (U_r + V_r (p_l - p_r) / (m c)) / (V_l + V_r),   with speeds beside the left one.
template <class T>
struct VolumeSide {
  T volume;    // m^3 (2D: m^2)
  T pressure;  // Pa
};
template <class T>
struct ParticlesOfOneFluid {
  T triple_mass, mass_times_sound_speed, per_mass_times_sound_speed;  // kg, kg m/s, s/(kg m)
};
template <class T>
struct RiemannParts {
  T volume;    // V_l + V_r
  T approach;  // U
  T pressing;  // V_l p_l + V_r p_r
  T damping;   // D
  T speed;     // U* (V_l + V_r) / V_l
};
template <class T>
KERF_FUNCTION RiemannParts<T> riemann_parts(const VolumeSide<T>& left, const VolumeSide<T>& right,
                                            T right_speed, const ParticlesOfOneFluid<T>& of) {
  const T approach = maximum(-right_speed, T(0));
  return {left.volume + right.volume, approach,
          left.volume * left.pressure + right.volume * right.pressure,
          minimum(of.triple_mass * approach, of.mass_times_sound_speed),
          right_speed +
              right.volume * of.per_mass_times_sound_speed * (left.pressure - right.pressure)};
}

// `smoothing`: the share of the difference in pressure that U* takes.
template <class T>
KERF_FUNCTION RiemannStar<T> solve_riemann(const RiemannSide<T>& left, const RiemannSide<T>& right,
                                           T smoothing = T(1)) {
  const T inverse = reciprocal(left.impedance + right.impedance);
  const T share_left = left.impedance * inverse, share_right = right.impedance * inverse;
  const T approach = maximum(left.speed - right.speed, T(0));
  const T slower = minimum(left.sound_speed, right.sound_speed);
  const T beta = minimum(approach * (T(3) * reciprocal(slower)), T(1));
  return {share_right * left.pressure + share_left * right.pressure,
          beta * share_left * right.impedance * approach,
          share_left * left.speed + share_right * right.speed +
              smoothing * (left.pressure - right.pressure) * inverse};
}

// In a strong shock the difference in pressure is the shock's own, not noise: density that it puts
// ahead of the front is squeezed once more there and is missing behind. So the share falls to
// nothing where two approach by a twentieth of the speed of sound.
template <class T>
KERF_FUNCTION T shock_smoothing(const RiemannSide<T>& left, const RiemannSide<T>& right) {
  return maximum(T(1) - T(20) * approach_of(left, right), T(0));
}

// What damps beyond the `viscous` pressure mu (U_l - U_r) / r that the viscosity of water has
// between the two (rates/water_viscosity.hpp): where water is thick enough to be smooth by itself
// nothing is added.
template <class T>
KERF_FUNCTION T beyond_viscosity(T dissipation, T viscous) {
  return select(magnitude(dissipation) > magnitude(viscous), dissipation - viscous, T(0));
}

// Fluid beside a wall, which may be rigid, or a solid that moves. The wall is the mirror of the
// fluid: the same density, the pressure of the fluid continued to the wall's place, a speed that
// makes the mean that of the wall. `hydrostatic`: rise of the pressure from the fluid to the wall.
// It is part of U*: without it the water above the floor would diffuse density upwards only, and
// its rows would sink together for as long as the run lasts.
template <class T>
KERF_FUNCTION RiemannStar<T> solve_riemann_at_wall(const RiemannSide<T>& fluid, T wall_speed,
                                                   T hydrostatic) {
  const RiemannSide<T> mirror{fluid.impedance,
                              fluid.pressure + (hydrostatic > T(0) ? hydrostatic : T(0)),
                              T(2) * wall_speed - fluid.speed, fluid.sound_speed};
  return solve_riemann(fluid, mirror);
}

}  // namespace kerf
