// SPDX-License-Identifier: Apache-2.0
// These functions are the terms that a neighbour j adds to the sums of a fluid particle i. Each is
// written once, for one number (the general pair loop, which runs on GPUs too) and for a register
// of numbers (the SIMD kernel, fluid/simd/fluid_pair_kernel.hpp). With d = r_i - r_j, v = v_i -
// v_j, the slope S = - (dW/dr) / r of the kernel, so that nabla_i W_ij = - S d, and the weight w =
// V_j S of a neighbour, the sums are
//   m_i dv_i/dt = 2 k V_i sum_j w [(P* + P_d) d - mu v],   P*, P_d, U* of fluid/riemann.hpp,
//   (1 / V_i) dV_i/dt = 2 k sum_j w r (U* - U_i),          mu of fluid/water_viscosity.hpp,
// where k normalises the kernel gradient (fluid/lattice_sums.hpp). The SIMD kernel leaves out of S
// what is the same for all pairs, and multiplies its sums by that.
#pragma once

#include "core/vector.hpp"

namespace kerf {

// Returns w = V_j S.
template <class T>
KERF_FORMULA T pair_weight(T volume, T slope) {
  return volume * slope;
}

// Returns the force of a pressure between the two, which acts along `direction`; for P* and P_d.
template <int D, class T>
KERF_FORMULA Vector<D, T> pair_force(T weight, T pressure, const Vector<D, T>& direction) {
  return (weight * pressure) * direction;
}

// Returns the force w mu v, which acts on i against its velocity relative to j (Morris, Fox & Zhu,
// J. Comput. Phys. 136 (1997) 214).
template <int D, class T>
KERF_FORMULA Vector<D, T> pair_drag(T weight, T viscosity, const Vector<D, T>& velocity) {
  return (weight * viscosity) * velocity;
}

// Returns w r U, the volumetric strain rate of i that is due to j, 1/s: their contact moves away
// from i at the speed U.
template <class T>
KERF_FORMULA T pair_strain_rate(T weight, T distance, T speed) {
  return weight * distance * speed;
}

}  // namespace kerf
