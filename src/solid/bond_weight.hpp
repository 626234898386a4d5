// SPDX-License-Identifier: Apache-2.0
// BondScale gives the weight of a bond in the sums of a solid, by the Wendland kernel
// (kernels/wendland_c2.hpp):
//   w_ij = V_i V_j |W'(R)| / R = K (1 - R / (2 h))^3,   in m (2D: 1),
// R the distance in the reference configuration, h the mean of both smoothing lengths. The sums
// need no more than a weight, since V_i V_j grad_0 W_ij = w_ij (X_j - X_i); and computing it costs
// less than loading it from memory.
#pragma once

#include "core/select.hpp"
#include "kernels/wendland_c2.hpp"
#include "model/medium.hpp"

namespace kerf {

// Of all bonds between two media.
template <class T>
struct BondScale {
  T largest;       // K, m (2D: 1); 0 where there are no bonds between the two
  T per_diameter;  // 1 / (2 h), 1/m

  // Returns the weight of an intact bond, or of a register of bonds; the same in both directions, 0
  // beyond the support.
  template <class Number>
  KERF_FORMULA Number weight(Number distance) const {
    using Kernel = WendlandC2<2>;  // its slope has the same shape in 3D
    return Number(largest) *
           Kernel::slope_shape(Kernel::edge_distance(distance, Number(per_diameter)));
  }

  template <int D>
  static BondScale of(const Medium<double>& a, const Medium<double>& b) {
    using Kernel = WendlandC2<D>;
    const double h = 0.5 * (a.smoothing_length + b.smoothing_length);
    const double largest = a.piece == b.piece ? a.reference_volume() * b.reference_volume() *
                                                    Kernel::slope_per_distance(0.0, h)
                                              : 0.0;
    return {static_cast<T>(largest), static_cast<T>(1.0 / (Kernel::support * h))};
  }
};

// Returns the weight of a bond of the length R, or of a register of bonds, to any level of a body,
// by that within the medium of particle i: with q = h_j / h_i and c = 2 / (1 + q), h is h_i / c,
// and K = V_i V_j 5 alpha / h^2 has the factor q^D c^(D + 2). `ratio`: q.
template <int D, class T, class Number>
KERF_FORMULA Number weight_of_levels(const BondScale<T>& within, Number ratio, Number distance) {
  const Number c = Number(2) * reciprocal(Number(1) + ratio), qc = ratio * c;
  const Number factor = (D == 3 ? qc * qc * qc : qc * qc) * c * c;
  return factor * BondScale<Number>{Number(within.largest), Number(within.per_diameter) * c}.weight(
                      distance);
}

// Returns 2 mu of two intact particles, Pa, which scales the moments of hourglass control; 1
// without it.
template <class T>
KERF_FUNCTION T hourglass_of_pair(const Medium<T>& medium) {
  const T own = medium.hourglass_modulus();
  return own > T(0) ? own + own : T(1);
}

// Returns w_ij of an intact bond, in double; 0 where there is none.
template <int D>
double intact_weight(const Medium<double>& a, const Medium<double>& b, double distance) {
  return BondScale<double>::of<D>(a, b).weight(distance);
}

}  // namespace kerf
