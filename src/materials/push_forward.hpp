// SPDX-License-Identifier: Apache-2.0
// These functions carry tensors between the reference and the current configuration.
#pragma once

#include "core/matrix.hpp"

namespace kerf {

// M S M^T; in two dimensions the component out of the plane stays.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> congruence(const Matrix<D, T>& m,
                                               const SymmetricTensor<D, T>& s) {
  const Matrix<D, T> half = m * in_plane(s);
  auto result = SymmetricTensor<D, T>::zero();
  if constexpr (D == 2) result(2, 2) = s(2, 2);
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b)
      for (int c = 0; c < D; ++c) result(a, b) += half(a, c) * m(b, c);
  return result;
}

template <int D, class T>
KERF_FUNCTION Matrix<D, T> inverse(const Matrix<D, T>& m) {
  Matrix<D, T> adjoint;
  if constexpr (D == 2) {
    adjoint = {{m(1, 1), -m(0, 1), -m(1, 0), m(0, 0)}};
  } else {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        const int c = (b + 1) % 3, d = (b + 2) % 3, e = (a + 1) % 3, f = (a + 2) % 3;
        adjoint(a, b) = m(c, e) * m(d, f) - m(c, f) * m(d, e);
      }
  }
  return (T(1) / determinant(m)) * adjoint;
}

}  // namespace kerf
