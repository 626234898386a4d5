// SPDX-License-Identifier: Apache-2.0
// These are second-order tensors. In two dimensions a symmetric tensor keeps its out-of-plane
// component: in plane strain the deviatoric stress s_zz is not zero.
#pragma once

#include "core/vector.hpp"

namespace kerf {

// A full D x D tensor, e.g. a velocity gradient: entry (a, b) = d v_a / d x_b.
template <int D, class T>
struct Matrix {
  T component[D * D];

  KERF_FUNCTION T& operator()(int a, int b) { return component[a * D + b]; }
  KERF_FUNCTION const T& operator()(int a, int b) const { return component[a * D + b]; }
  template <class Other>
  KERF_FUNCTION static Matrix from(const Matrix<D, Other>& other) {
    Matrix m;
    for (int k = 0; k < D * D; ++k) m.component[k] = static_cast<T>(other.component[k]);
    return m;
  }
  KERF_FUNCTION static Matrix zero() {
    Matrix m;
    for (int k = 0; k < D * D; ++k) m.component[k] = T(0);
    return m;
  }
  KERF_FUNCTION T trace() const {
    T sum = T(0);
    for (int a = 0; a < D; ++a) sum += (*this)(a, a);
    return sum;
  }
};

// A symmetric tensor of three-dimensional space whose components out of the plane of a
// two-dimensional run vanish, but for zz.
//   D = 2: xx yy zz xy        D = 3: xx yy zz xy xz yz
template <int D, class T>
struct SymmetricTensor {
  static constexpr int count = D == 2 ? 4 : 6;
  T component[count];

  // Index of entry (a, b); a and b run to 2 on the diagonal even when D = 2.
  KERF_FUNCTION static constexpr int index(int a, int b) { return a == b ? a : 2 + a + b; }
  KERF_FUNCTION T& operator()(int a, int b) { return component[index(a, b)]; }
  KERF_FUNCTION const T& operator()(int a, int b) const { return component[index(a, b)]; }
  template <class Other>
  KERF_FUNCTION static SymmetricTensor from(const SymmetricTensor<D, Other>& other) {
    SymmetricTensor s;
    for (int k = 0; k < count; ++k) s.component[k] = static_cast<T>(other.component[k]);
    return s;
  }
  KERF_FUNCTION static SymmetricTensor zero() {
    SymmetricTensor s;
    for (int k = 0; k < count; ++k) s.component[k] = T(0);
    return s;
  }
  KERF_FUNCTION SymmetricTensor& operator+=(const SymmetricTensor& other) {
    for (int k = 0; k < count; ++k) component[k] += other.component[k];
    return *this;
  }
  KERF_FUNCTION SymmetricTensor& operator*=(T factor) {
    for (int k = 0; k < count; ++k) component[k] *= factor;
    return *this;
  }
  KERF_FUNCTION friend SymmetricTensor operator+(SymmetricTensor u, const SymmetricTensor& v) {
    return u += v;
  }
  KERF_FUNCTION friend SymmetricTensor operator*(T factor, SymmetricTensor s) {
    return s *= factor;
  }
};

// A skew tensor, e.g. a spin: entry (a, b) = - (b, a); the entries above the diagonal are kept.
//   D = 2: xy        D = 3: xy xz yz
template <int D, class T>
struct SkewTensor {
  static constexpr int count = D * (D - 1) / 2;
  T component[count];

  KERF_FUNCTION T operator()(int a, int b) const {
    if (a == b) return T(0);
    return a < b ? component[a + b - 1] : -component[a + b - 1];
  }
  // (m - m^T) / 2
  KERF_FUNCTION static SkewTensor part_of(const Matrix<D, T>& m) {
    SkewTensor w;
    for (int a = 0; a < D; ++a)
      for (int b = a + 1; b < D; ++b) w.component[a + b - 1] = T(0.5) * (m(a, b) - m(b, a));
    return w;
  }
};

// Returns whether every eigenvalue of a symmetric m is above `least`. Then, and only then, the
// elimination of m - least 1 has positive pivots (Sylvester's law of inertia), in whatever order
// the axes come.
template <int D, class T>
KERF_FUNCTION bool has_eigenvalues_above(Matrix<D, T> m, T least) {
  for (int k = 0; k < D; ++k) m(k, k) -= least;
  for (int k = 0; k < D; ++k) {
    if (!(m(k, k) > T(0))) return false;
    for (int b = k + 1; b < D; ++b) {
      const T factor = m(k, b) / m(k, k);
      for (int a = k + 1; a < D; ++a) m(a, b) -= factor * m(a, k);
    }
  }
  return true;
}

// Solves X m = y for X, where m is symmetric; y becomes X. Returns false and leaves y unchanged
// unless every eigenvalue of m is above `least`, which is not negative.
template <int D, class T>
KERF_FUNCTION bool divide(Matrix<D, T>& y, Matrix<D, T> m, T least) {
  if (!has_eigenvalues_above(m, least)) return false;
  Matrix<D, T> x = y;
  for (int k = 0; k < D; ++k) {  // column elimination: pivots of such an m need no exchange
    for (int b = k + 1; b < D; ++b) {
      const T factor = m(k, b) / m(k, k);
      for (int a = 0; a < D; ++a) {
        m(a, b) -= factor * m(a, k);
        x(a, b) -= factor * x(a, k);
      }
    }
  }
  for (int k = D - 1; k >= 0; --k) {
    for (int a = 0; a < D; ++a) {
      for (int c = k + 1; c < D; ++c) x(a, k) -= x(a, c) * m(c, k);
      x(a, k) /= m(k, k);
    }
  }
  y = x;
  return true;
}

// In-plane action on a vector: (S v)_a = S_ab v_b.
template <int D, class T>
KERF_FUNCTION Vector<D, T> operator*(const SymmetricTensor<D, T>& s, const Vector<D, T>& v) {
  Vector<D, T> product = Vector<D, T>::zero();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) product[a] += s(a, b) * v[b];
  return product;
}

// Full contraction S : S over three dimensions.
template <int D, class T>
KERF_FUNCTION T contract(const SymmetricTensor<D, T>& s, const SymmetricTensor<D, T>& u) {
  T sum = T(0);
  for (int k = 0; k < 3; ++k) sum += s.component[k] * u.component[k];
  for (int k = 3; k < SymmetricTensor<D, T>::count; ++k)
    sum += T(2) * s.component[k] * u.component[k];
  return sum;
}

// S : grad v, the stress power per volume; d v_z / d z = 0 in plane strain.
template <int D, class T>
KERF_FUNCTION T contract(const SymmetricTensor<D, T>& s, const Matrix<D, T>& gradient) {
  T sum = T(0);
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) sum += s(a, b) * gradient(a, b);
  return sum;
}

}  // namespace kerf
