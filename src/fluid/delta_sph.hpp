// SPDX-License-Identifier: Apache-2.0
// CentralWater is the pair interaction of water in delta-SPH (Antuono, Colagrossi, Marrone &
// Molteni, Comput. Phys. Commun. 181 (2010) 532), in the form of a Riemann solution
// (fluid/riemann.hpp), so that the same sums of force and continuity serve both: U* and P* are
// arithmetic means, and
//   P_d = alpha rho c h (U_l - U_r) / (2 r)
// is the artificial viscosity  m_i dv_i/dt = alpha rho_0 c h sum V_i V_j (v_ij . r_ij / r^2) nabla
// W, where particles part as well as where they approach. Its power is never negative.
#pragma once

#include "fluid/riemann.hpp"

namespace kerf {

struct CentralWater {
  static constexpr double viscosity = 0.02;  // alpha; Antuono et al.

  // `ratio`: h over the distance of the two.
  template <class T>
  KERF_FUNCTION static RiemannStar<T> solve(const RiemannSide<T>& left, const RiemannSide<T>& right,
                                            T ratio) {
    const T impedance = T(0.5) * (left.impedance + right.impedance);
    return {T(0.5) * (left.pressure + right.pressure),
            T(0.5 * viscosity) * impedance * ratio * (left.speed - right.speed),
            T(0.5) * (left.speed + right.speed)};
  }
};

}  // namespace kerf
