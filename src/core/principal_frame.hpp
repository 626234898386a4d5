// SPDX-License-Identifier: Apache-2.0
// PrincipalFrame holds the principal values and axes of a symmetric tensor. Jacobi's rotations
// (Golub & Van Loan, Matrix Computations, section 8.5) give them to a few roundings of the largest
// value, also for close values. The closed forms of Eigen are faster, but lose a digit
// or more for close values, which is too much for elastic strains of 1e-3 in single precision.
#pragma once

#include <cmath>
#include <limits>

#include "core/matrix.hpp"

namespace kerf {

template <int D, class T>
struct PrincipalFrame {
  Vector<3, T> value;  // in no order; in two dimensions the last is along z
  Matrix<D, T> axes;   // column k: unit vector of value[k]

  KERF_FUNCTION static PrincipalFrame of(SymmetricTensor<D, T> tensor) {
    PrincipalFrame frame;
    frame.axes = identity<D, T>();
    T largest = T(0);
    for (int k = 0; k < SymmetricTensor<D, T>::count; ++k)
      largest = largest < std::abs(tensor.component[k]) ? std::abs(tensor.component[k]) : largest;
    const T nothing = T(0.25) * std::numeric_limits<T>::epsilon() * largest;
    bool done = false;
    for (int sweep = 0; sweep < 8 && !done; ++sweep) {  // 4 or 5 suffice, one in the plane
      done = true;
      for (int p = 0; p < D; ++p)
        for (int q = p + 1; q < D; ++q) done &= !frame.rotate(tensor, p, q, nothing);
    }
    for (int a = 0; a < 3; ++a) frame.value[a] = tensor(a, a);
    return frame;
  }

  // The tensor that has these axes and these principal values.
  KERF_FUNCTION SymmetricTensor<D, T> tensor(const Vector<3, T>& values) const {
    auto sum = SymmetricTensor<D, T>::zero();
    if constexpr (D == 2) sum(2, 2) = values[2];
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b)
        for (int k = 0; k < D; ++k) sum(a, b) += values[k] * axes(a, k) * axes(b, k);
    return sum;
  }

 private:
  // Rotates in the plane p, q so that entry (p, q) becomes 0; returns false if it is negligible.
  KERF_FUNCTION bool rotate(SymmetricTensor<D, T>& tensor, int p, int q, T nothing) {
    const T off = tensor(p, q);
    if (!(std::abs(off) > nothing)) return false;
    const T ratio = (tensor(q, q) - tensor(p, p)) / (T(2) * off);
    const T root = std::sqrt(ratio * ratio + T(1));
    const T tangent = ratio < T(0) ? T(1) / (ratio - root) : T(1) / (ratio + root);
    const T cosine = T(1) / std::sqrt(tangent * tangent + T(1)), sine = tangent * cosine;
    tensor(p, p) -= tangent * off;
    tensor(q, q) += tangent * off;
    tensor(p, q) = T(0);
    for (int r = 0; r < D; ++r) {
      if (r != p && r != q) turn(tensor(r, p), tensor(r, q), cosine, sine);
      turn(axes(r, p), axes(r, q), cosine, sine);
    }
    return true;
  }

  KERF_FUNCTION static void turn(T& u, T& v, T cosine, T sine) {
    const T before = u;
    u = cosine * before - sine * v;
    v = sine * before + cosine * v;
  }
};

}  // namespace kerf
