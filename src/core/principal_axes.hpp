// SPDX-License-Identifier: Apache-2.0
// These functions find the principal axes of a symmetric tensor by Eigen's closed forms.
#pragma once

#include <Eigen/Dense>

#include "core/tensor.hpp"

namespace kerf {

// The tensor with its negative principal values set to zero.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> tensile_part(const SymmetricTensor<D, T>& tensor) {
  Eigen::Matrix<T, D, D> in_plane;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) in_plane(a, b) = tensor(a, b);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<T, D, D>> solver;
  solver.computeDirect(in_plane);
  auto result = SymmetricTensor<D, T>::zero();
  for (int k = 0; k < D; ++k) {
    const T value = solver.eigenvalues()(k);
    if (!(value > T(0))) continue;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b)
        result(a, b) += value * solver.eigenvectors()(a, k) * solver.eigenvectors()(b, k);
  }
  return result;
}

}  // namespace kerf
