// SPDX-License-Identifier: Apache-2.0
// The cubic spline kernel, eqs. (5) and (6) of Shinohara et al. (2004), after Monaghan (1992), is
//   W(r, h) = h^-D sigma f(s),  s = r / h,  support 2 h,
//   f = 2/3 - s^2 + s^3/2   for s < 1,      f = (2 - s)^3 / 6   for 1 <= s < 2,
// with the normalisation sigma = 15/(7 pi) in 2D, 3/(2 pi) in 3D.
#pragma once

#include "core/vector.hpp"

namespace kerf {

template <int D>
struct CubicSpline {
  static constexpr double support = 2.0;  // in units of h
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double sigma = D == 2 ? 15.0 / (7.0 * pi) : 3.0 / (2.0 * pi);

  template <class T>
  KERF_FUNCTION static T scale(T h) {  // h^-D sigma
    return T(sigma) / (D == 2 ? h * h : h * h * h);
  }

  // W, 1/m^D.
  template <class T>
  KERF_FUNCTION static T value(T distance, T h) {
    const T s = distance / h;
    const T outer = T(2) - s > T(0) ? T(2) - s : T(0);
    const T inner = T(1) - s > T(0) ? T(1) - s : T(0);
    // (2-s)^3/6 - 4 (1-s)^3/6 equals 2/3 - s^2 + s^3/2 for s < 1.
    return scale(h) * (outer * outer * outer - T(4) * inner * inner * inner) / T(6);
  }

  // dW/dr, 1/m^(D+1); never positive.
  template <class T>
  KERF_FUNCTION static T derivative(T distance, T h) {
    const T s = distance / h;
    const T outer = T(2) - s > T(0) ? T(2) - s : T(0);
    const T inner = T(1) - s > T(0) ? T(1) - s : T(0);
    return scale(h) / h * (T(2) * inner * inner - outer * outer / T(2));
  }

  // S = - dW/dr / r, 1/m^(D+2); 0 where r is 0.
  template <class T>
  KERF_FUNCTION static T slope_per_distance(T distance, T h) {
    return distance > T(0) ? -derivative(distance, h) / distance : T(0);
  }
};

}  // namespace kerf
