// SPDX-License-Identifier: Apache-2.0
// These functions are the low-dissipation Riemann solution between two fluid particles along their
// line of centres (Zhang, Hu & Adams, J. Comput. Phys. 335 (2017) 605), for one number or for a
// register of numbers. With e from j to i, the left state is i and the right one j, U = - v . e,
// and Z = rho c the impedance of a side (acoustic solution: Toro, Riemann Solvers and Numerical
// Methods for Fluid Dynamics, 3rd ed. (2009), section 9.3):
//   P* = (Z_r p_l + Z_l p_r) / (Z_l + Z_r) + beta Z_l Z_r (U_l - U_r) / (Z_l + Z_r),
//   U* = (Z_l U_l + Z_r U_r + p_l - p_r) / (Z_l + Z_r),
//   beta = min(3 max(U_l - U_r, 0) / c, 1),   c: the lesser of both.
// beta switches the dissipation off where particles part or hardly approach. The difference in
// pressure in U* diffuses density, which keeps the pressure smooth.
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
  T mean_pressure;  // Pa, the reversible part of P*
  T dissipation;    // Pa, P_d, the part that turns motion into heat; never negative
  T speed;          // m/s, U*
};

// Returns the speed at which the two approach over the lesser sound speed; 0 where they part.
template <class T>
KERF_FORMULA T approach_of(const RiemannSide<T>& left, const RiemannSide<T>& right) {
  return maximum(left.speed - right.speed, T(0)) *
         reciprocal(minimum(left.sound_speed, right.sound_speed));
}

// Returns the solution; riemann_parts below is its second form, for particles of one fluid without
// shocks. `smoothing` is the share of the difference in pressure that U* takes.
template <class T>
KERF_FORMULA RiemannStar<T> solve_riemann(const RiemannSide<T>& left, const RiemannSide<T>& right,
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

// riemann_parts is the second form of solve_riemann, for two particles of one fluid whose sound
// speed c is the same everywhere, so that Z = m c / V. It leaves out the common factors:
//   P* = (V_l p_l + V_r p_r + U D) / (V_l + V_r),   U = max(- U_r, 0),   D = m min(3 U, c),
//   U* = V_l (U_r + V_r (p_l - p_r) / (m c)) / (V_l + V_r),   with speeds relative to the left one.
// The SIMD kernel uses this form, because with solve_riemann it takes 15% longer in 3D and 11%
// longer in 2D (single precision, AVX-512). RiemannByVolumes of tests/unit/fluid/simd_test.cpp
// holds the two forms together.
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
  T volume;             // V_l + V_r
  T approach;           // U
  T pressure_force;     // V_l p_l + V_r p_r
  T dissipative_force;  // D
  T speed;              // U* (V_l + V_r) / V_l
};
template <class T>
KERF_FORMULA RiemannParts<T> riemann_parts(const VolumeSide<T>& left, const VolumeSide<T>& right,
                                           T right_speed, const ParticlesOfOneFluid<T>& of) {
  const T approach = maximum(-right_speed, T(0));
  return {left.volume + right.volume, approach,
          left.volume * left.pressure + right.volume * right.pressure,
          minimum(of.triple_mass * approach, of.mass_times_sound_speed),
          right_speed +
              right.volume * of.per_mass_times_sound_speed * (left.pressure - right.pressure)};
}

// Returns the `smoothing` of solve_riemann for fluids with shocks. In a strong shock the difference
// in pressure is the shock's own, not noise: density that it diffuses ahead of the front is
// compressed once more there and is missing behind. So the share falls to zero where the two
// approach at a twentieth of the sound speed.
template <class T>
KERF_FORMULA T shock_smoothing(const RiemannSide<T>& left, const RiemannSide<T>& right) {
  return maximum(T(1) - T(20) * approach_of(left, right), T(0));
}

// Returns what is left of a dissipation without the `viscous` pressure mu (U_l - U_r) / r that the
// viscosity of water (fluid/water_viscosity.hpp) has between the two: where water is viscous enough
// to be smooth by itself nothing is added. Neither may be negative.
template <class T>
KERF_FORMULA T beyond_viscosity(T dissipation, T viscous) {
  return maximum(dissipation - viscous, T(0));
}

// Returns the solution between fluid and its mirror image behind a wall, whose pressure is higher
// by `rise`, Pa, but not negative.
template <class T>
KERF_FORMULA RiemannStar<T> solve_riemann_at_mirror(const RiemannSide<T>& fluid, T wall_speed,
                                                    T rise) {
  const RiemannSide<T> mirror{fluid.impedance, maximum(fluid.pressure + rise, T(0)),
                              T(2) * wall_speed - fluid.speed, fluid.sound_speed};
  return solve_riemann(fluid, mirror);
}

// Returns the solution between fluid and a wall, which may be rigid, or a solid that moves. The
// wall is the mirror image of the fluid: the same density, the pressure of the fluid continued to
// the wall, and a speed with which the mean of both is that of the wall. `hydrostatic` is the rise
// of the pressure from the fluid to the wall, Pa. It is part of U*: without it the water above the
// floor would diffuse density upwards only, and its rows would sink together for as long as the run
// lasts.
template <class T>
KERF_FORMULA RiemannStar<T> solve_riemann_at_wall(const RiemannSide<T>& fluid, T wall_speed,
                                                  T hydrostatic) {
  return solve_riemann_at_mirror(fluid, wall_speed, maximum(hydrostatic, T(0)));
}

// Returns the dissipation of fluid that comes to a wall at the speed `into`, Pa.
template <class T>
KERF_FORMULA T wall_dissipation(const RiemannSide<T>& fluid, T into) {
  const RiemannSide<T> coming{fluid.impedance, fluid.pressure, into, fluid.sound_speed};
  return solve_riemann_at_wall(coming, T(0), T(0)).dissipation;
}

}  // namespace kerf
