// SPDX-License-Identifier: Apache-2.0
// Quintic kernel of Wendland, Adv. Comput. Math. 4 (1995) 389, continuous in its second derivative:
//   W(r, h) = alpha (1 - q/2)^4 (2 q + 1),  q = r / h,  support 2 h,
// alpha = 7/(4 pi h^2) in 2D, 21/(16 pi h^3) in 3D. Its Fourier transform is positive, so that many
// neighbours do not pair up (Dehnen & Aly, Mon. Not. R. Astron. Soc. 425 (2012) 1068).
#pragma once

#include "core/vector.hpp"

namespace kerf {

template <int D>
struct WendlandC2 {
  static constexpr double support = 2.0;  // in units of h
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double sigma = D == 2 ? 7.0 / (4.0 * pi) : 21.0 / (16.0 * pi);

  template <class T>
  KERF_FUNCTION static T scale(T h) {  // alpha
    return T(sigma) / (D == 2 ? h * h : h * h * h);
  }

  // W, 1/m^D.
  template <class T>
  KERF_FUNCTION static T value(T distance, T h) {
    const T q = distance / h;
    const T rest = T(1) - T(0.5) * q > T(0) ? T(1) - T(0.5) * q : T(0);
    return scale(h) * (rest * rest) * (rest * rest) * (T(2) * q + T(1));
  }

  // dW/dr, 1/m^(D+1); never positive.
  template <class T>
  KERF_FUNCTION static T derivative(T distance, T h) {
    return -distance * slope_per_distance(distance, h);
  }

  // - dW/dr / r, 1/m^(D+2): finite where r vanishes.
  template <class T>
  KERF_FUNCTION static T slope_per_distance(T distance, T h) {
    const T q = distance / h;
    const T rest = T(1) - T(0.5) * q > T(0) ? T(1) - T(0.5) * q : T(0);
    return T(5) * scale(h) / (h * h) * rest * rest * rest;
  }
};

}  // namespace kerf
