// SPDX-License-Identifier: Apache-2.0
// Instantaneous simple fracture, section 2.3 of Shinohara et al. (2004): a particle fractures when
// the equivalent strain of its principal elastic strains,
//   (sqrt(2)/3) sqrt[(e1-e2)^2 + (e2-e3)^2 + (e3-e1)^2],
// exceeds the failure strain. The pressure part of the strain is the same on every axis and drops
// out of the differences, and for the deviatoric part e' = s/2G the bracket is 3 e':e', so that the
// equivalent strain is sqrt(2/3 e':e') = sqrt(2/3 s:s) / 2G, without solving for principal axes.
#pragma once

#include <cmath>

#include "core/tensor.hpp"
#include "particles/medium.hpp"

namespace kerf {

template <int D, class T>
KERF_FUNCTION T equivalent_strain(const SymmetricTensor<D, T>& s, T shear_modulus) {
  return std::sqrt(T(2) / T(3) * contract(s, s)) / (T(2) * shear_modulus);
}

}  // namespace kerf
