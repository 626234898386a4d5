// SPDX-License-Identifier: Apache-2.0
// These functions compute measures of large deformation. They start from the displacement gradient
// H = F - 1, not from F: in single precision F has lost every digit of a strain below 1e-7, and
// half of the digits of a strain of 1e-4.
#pragma once

#include <cmath>

#include "core/matrix.hpp"

namespace kerf {

// Green's strain E = (F^T F - 1) / 2 = (H + H^T + H^T H) / 2; in plane strain E_zz = 0.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> green_strain(const Matrix<D, T>& h) {
  auto e = SymmetricTensor<D, T>::zero();
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) {
      T square = T(0);
      for (int c = 0; c < D; ++c) square += h(c, a) * h(c, b);
      e(a, b) = T(0.5) * (h(a, b) + h(b, a) + square);
    }
  return e;
}

template <int D, class T>
KERF_FUNCTION T trace(const SymmetricTensor<D, T>& s) {
  return s.component[0] + s.component[1] + s.component[2];
}

// Determinant of the tensor in three-dimensional space.
template <int D, class T>
KERF_FUNCTION T determinant(const SymmetricTensor<D, T>& s) {
  const T plane = s(0, 0) * s(1, 1) - s(0, 1) * s(0, 1);
  if constexpr (D == 2) {
    return plane * s(2, 2);
  } else {
    return plane * s(2, 2) + T(2) * s(0, 1) * s(0, 2) * s(1, 2) - s(0, 2) * s(0, 2) * s(1, 1) -
           s(1, 2) * s(1, 2) * s(0, 0);
  }
}

// Sum of the principal minors.
template <int D, class T>
KERF_FUNCTION T second_invariant(const SymmetricTensor<D, T>& s) {
  T sum = s(0, 0) * s(1, 1) + s(1, 1) * s(2, 2) + s(2, 2) * s(0, 0);
  for (int k = 3; k < SymmetricTensor<D, T>::count; ++k) sum -= s.component[k] * s.component[k];
  return sum;
}

// J^2 - 1 = det(1 + 2 E) - 1, without the loss of digits of the difference.
template <int D, class T>
KERF_FUNCTION T volume_square_less_one(const SymmetricTensor<D, T>& green) {
  return T(2) * trace(green) + T(4) * second_invariant(green) + T(8) * determinant(green);
}

template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> inverse(const SymmetricTensor<D, T>& s) {
  SymmetricTensor<D, T> adjoint;
  adjoint(2, 2) = s(0, 0) * s(1, 1) - s(0, 1) * s(0, 1);
  if constexpr (D == 2) {
    adjoint(0, 0) = s(1, 1) * s(2, 2);
    adjoint(1, 1) = s(0, 0) * s(2, 2);
    adjoint(0, 1) = -s(0, 1) * s(2, 2);
  } else {
    adjoint(0, 0) = s(1, 1) * s(2, 2) - s(1, 2) * s(1, 2);
    adjoint(1, 1) = s(0, 0) * s(2, 2) - s(0, 2) * s(0, 2);
    adjoint(0, 1) = s(0, 2) * s(1, 2) - s(0, 1) * s(2, 2);
    adjoint(0, 2) = s(0, 1) * s(1, 2) - s(0, 2) * s(1, 1);
    adjoint(1, 2) = s(0, 1) * s(0, 2) - s(0, 0) * s(1, 2);
  }
  return (T(1) / determinant(s)) * adjoint;
}

// The product of two symmetric tensors with the same principal axes, which is symmetric too.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> coaxial_product(const SymmetricTensor<D, T>& s,
                                                    const SymmetricTensor<D, T>& u) {
  auto product = SymmetricTensor<D, T>::zero();
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b)
      for (int c = 0; c < D; ++c) product(a, b) += s(a, c) * u(c, b);
  if constexpr (D == 2) product(2, 2) = s(2, 2) * u(2, 2);
  return product;
}

// Bounds of the principal values, but for rounding: mean -+ 2 sqrt(s':s' / 6).
template <class T>
struct PossibleValues {
  T least, most;
};
template <int D, class T>
KERF_FUNCTION PossibleValues<T> possible_values(SymmetricTensor<D, T> s) {
  const T mean = trace(s) / T(3);
  for (int a = 0; a < 3; ++a) s(a, a) -= mean;
  const T farthest = T(2) * std::sqrt(contract(s, s) / T(6));
  return {mean - farthest, mean + farthest};
}

// The three principal values, in no order: by the closed form in 2D, by the angle of the cubic's
// roots in 3D (Smith, Commun. ACM 4 (1961) 168).
template <int D, class T>
KERF_FUNCTION Vector<3, T> principal_values(const SymmetricTensor<D, T>& s) {
  Vector<3, T> values;
  if constexpr (D == 2) {
    const T mean = T(0.5) * (s(0, 0) + s(1, 1)), half = T(0.5) * (s(0, 0) - s(1, 1));
    const T radius = std::sqrt(half * half + s(0, 1) * s(0, 1));
    values[0] = mean + radius;
    values[1] = mean - radius;
    values[2] = s(2, 2);
  } else {
    const T mean = trace(s) / T(3);
    SymmetricTensor<D, T> rest = s;
    for (int a = 0; a < 3; ++a) rest(a, a) -= mean;
    const T size = std::sqrt(contract(rest, rest) / T(6));
    for (int a = 0; a < 3; ++a) values[a] = mean;
    if (!(size > T(0))) return values;
    T cosine = determinant((T(1) / size) * rest) / T(2);
    cosine = cosine < T(-1) ? T(-1) : cosine > T(1) ? T(1) : cosine;
    const T angle = std::acos(cosine) / T(3), third = T(2.0943951023931953);  // 2 pi / 3
    for (int a = 0; a < 3; ++a) values[a] += T(2) * size * std::cos(angle + T(a) * third);
  }
  return values;
}

}  // namespace kerf
