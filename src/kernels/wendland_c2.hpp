// SPDX-License-Identifier: Apache-2.0
// This kernel of Wendland, Adv. Comput. Math. 4 (1995) 389, is a polynomial of degree 5 with a
// continuous second derivative:
//   W(r, h) = alpha (1 - q/2)^4 (2 q + 1),  q = r / h,  support 2 h,
// alpha = 7/(4 pi h^2) in 2D, 21/(16 pi h^3) in 3D. Its Fourier transform is positive, so that many
// neighbours do not pair up (Dehnen & Aly, Mon. Not. R. Astron. Soc. 425 (2012) 1068).
#pragma once

#include "core/select.hpp"
#include "core/vector.hpp"

namespace kerf {

template <int D>
struct WendlandC2 {
  static constexpr double support = 2.0;  // in units of h
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double sigma = D == 2 ? 7.0 / (4.0 * pi) : 21.0 / (16.0 * pi);

  template <class T>
  KERF_FORMULA static T scale(T h) {  // alpha
    return T(sigma) / (D == 2 ? h * h : h * h * h);
  }

  // W, 1/m^D.
  template <class T>
  KERF_FORMULA static T value(T distance, T h) {
    return scale(h) * value_shape(edge_distance(distance / h, T(0.5)));
  }

  // dW/dr, 1/m^(D+1); never positive.
  template <class T>
  KERF_FORMULA static T derivative(T distance, T h) {
    return -distance * slope_per_distance(distance, h);
  }

  // S = - dW/dr / r, 1/m^(D+2): finite where r vanishes.
  template <class T>
  KERF_FORMULA static T slope_per_distance(T distance, T h) {
    return slope_shape(edge_distance(distance / h, T(0.5)), T(5) * scale(h) / (h * h));
  }

  // The kernel's formulas, for one number or for a register of numbers. They depend on w = 1 - q/2,
  // which is 0 beyond the support:
  //   W = alpha w^4 (5 - 4 w),   S = 5 alpha / h^2 w^3.
  // Returns w, given 1 / (2 h) in the unit of `distance`.
  template <class T>
  KERF_FORMULA static T edge_distance(T distance, T per_diameter) {
    return maximum(T(1) - distance * per_diameter, T(0));
  }
  // Returns W / alpha.
  template <class T>
  KERF_FORMULA static T value_shape(T w) {
    return slope_shape(w) * w * (T(5) - T(4) * w);
  }
  // Returns S, given `factor` = 5 alpha / h^2.
  template <class T>
  KERF_FORMULA static T slope_shape(T w, T factor = T(1)) {
    return factor * w * w * w;
  }
};

}  // namespace kerf
