// SPDX-License-Identifier: Apache-2.0
// These functions multiply the tensors of core/tensor.hpp.
#pragma once

#include "core/tensor.hpp"

namespace kerf {

template <int D, class T>
KERF_FUNCTION Matrix<D, T> operator*(const Matrix<D, T>& m, const Matrix<D, T>& n) {
  auto product = Matrix<D, T>::zero();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b)
      for (int c = 0; c < D; ++c) product(a, b) += m(a, c) * n(c, b);
  return product;
}

template <int D, class T>
KERF_FUNCTION Matrix<D, T> operator*(T factor, Matrix<D, T> m) {
  for (int k = 0; k < D * D; ++k) m.component[k] *= factor;
  return m;
}

template <int D, class T>
KERF_FUNCTION Matrix<D, T>& operator+=(Matrix<D, T>& m, const Matrix<D, T>& n) {
  for (int k = 0; k < D * D; ++k) m.component[k] += n.component[k];
  return m;
}

template <int D, class T>
KERF_FUNCTION Matrix<D, T> operator+(Matrix<D, T> m, const Matrix<D, T>& n) {
  return m += n;
}

template <int D, class T>
KERF_FUNCTION Vector<D, T> operator*(const Matrix<D, T>& m, const Vector<D, T>& v) {
  auto product = Vector<D, T>::zero();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) product[a] += m(a, b) * v[b];
  return product;
}

// m += u (x) v
template <int D, class T>
KERF_FUNCTION void add_outer(Matrix<D, T>& m, const Vector<D, T>& u, const Vector<D, T>& v) {
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) m(a, b) += u[a] * v[b];
}

template <int D, class T>
KERF_FUNCTION Matrix<D, T> identity() {
  auto m = Matrix<D, T>::zero();
  for (int a = 0; a < D; ++a) m(a, a) = T(1);
  return m;
}

template <int D, class T>
KERF_FUNCTION Matrix<D, T> transposed(const Matrix<D, T>& m) {
  Matrix<D, T> result;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) result(a, b) = m(b, a);
  return result;
}
template <int D, class T>
KERF_FUNCTION T determinant(const Matrix<D, T>& m) {
  if constexpr (D == 2)
    return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  else
    return m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
           m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
           m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
}

// Returns the transposed matrix of cofactors in three dimensions, m^2 - m tr m + 1/2 (tr^2 m - tr
// m^2) (Cayley and Hamilton).
template <class T>
KERF_FUNCTION Matrix<3, T> adjugate(const Matrix<3, T>& m) {
  const auto square = m * m;
  const T trace = m.trace();
  return square + T(-1) * trace * m + T(0.5) * (trace * trace - square.trace()) * identity<3, T>();
}

// The in-plane part of a symmetric tensor.
template <int D, class T>
KERF_FUNCTION Matrix<D, T> in_plane(const SymmetricTensor<D, T>& s) {
  Matrix<D, T> m;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) m(a, b) = s(a, b);
  return m;
}

}  // namespace kerf
