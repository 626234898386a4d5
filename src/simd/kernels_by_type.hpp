// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf {

// One set of kernels for each dimension and precision.
template <template <int, class> class Kernels>
struct KernelsByType {
  Kernels<2, float> single_2d;
  Kernels<3, float> single_3d;
  Kernels<2, double> double_2d;
  Kernels<3, double> double_3d;

  template <int D, class Real>
  const Kernels<D, Real>& get() const {
    constexpr bool single = sizeof(Real) == sizeof(float);
    if constexpr (D == 2 && single) return single_2d;
    if constexpr (D == 3 && single) return single_3d;
    if constexpr (D == 2 && !single) return double_2d;
    if constexpr (D == 3 && !single) return double_3d;
  }
};

}  // namespace kerf
