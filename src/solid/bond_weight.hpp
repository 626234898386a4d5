// SPDX-License-Identifier: Apache-2.0
// The weight of a bond in the sums of a solid, of the Wendland kernel (kernels/wendland_c2.hpp):
//   w_ij = V_i V_j |W'(R)| / R = K (1 - R / (2 h))^3,   in m (2D: 1),
// R the distance in the reference configuration, h the mean of both smoothing lengths. A weight is
// all that the sums need, since V_i V_j grad_0 W_ij = w_ij (X_j - X_i); and it costs less to work
// out than to fetch from memory.
#pragma once

#include "core/select.hpp"
#include "kernels/wendland_c2.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

// Of all bonds between two media.
template <class T>
struct BondScale {
  T largest;       // K, m (2D: 1); 0 where there are no bonds between the two
  T per_diameter;  // 1 / (2 h), 1/m

  // Of an unbroken bond, or of several side by side; the same number in both directions, 0 beyond
  // the kernel.
  template <class Number>
  KERF_FUNCTION Number weight(Number distance) const {
    const Number rest = maximum(Number(1) - distance * Number(per_diameter), Number(0));
    return Number(largest) * (rest * rest * rest);
  }

  template <int D>
  static BondScale of(const SolidMedium<double>& a, const SolidMedium<double>& b) {
    using Kernel = WendlandC2<D>;
    const double h = 0.5 * (a.smoothing_length + b.smoothing_length);
    const double largest =
        a.piece == b.piece ? a.volume() * b.volume() * Kernel::slope_per_distance(0.0, h) : 0.0;
    return {static_cast<T>(largest), static_cast<T>(1.0 / (Kernel::support * h))};
  }
};

// w_ij of a whole bond, in double; 0 where there is none.
template <int D>
double whole_weight(const SolidMedium<double>& a, const SolidMedium<double>& b, double distance) {
  return BondScale<double>::of<D>(a, b).weight(distance);
}

}  // namespace kerf
