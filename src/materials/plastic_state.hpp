// SPDX-License-Identifier: Apache-2.0
// PlasticState is the history of a particle of a solid that flows.
#pragma once

#include "core/tensor.hpp"

namespace kerf {

// The plastic metric is kept as A = C_p^-1 - 1, its difference from the identity: in single
// precision C_p^-1 itself has lost every digit of a plastic strain below 1e-7.
template <int D, class T>
struct PlasticState {
  SymmetricTensor<D, T> metric;  // A, 1
  T plastic_strain;              // 1, the sum of sqrt(2/3 d : d) dt of the flow's deviator d
  T temperature_rise;            // K, since the start, by plastic work without conduction
  T damage;                      // 1; 0 = undamaged, 1 = failed

  KERF_FUNCTION static PlasticState virgin() {
    return {SymmetricTensor<D, T>::zero(), T(0), T(0), T(0)};
  }
};

template <int D, class T>
struct PlasticResult {
  SymmetricTensor<D, T> stress;  // S, Pa: second Piola-Kirchhoff, so that P = F S
  PlasticState<D, T> state;      // at the end of the step
  T stored_energy;               // J per m^3 of the reference configuration
  T plastic_work;                // of this step, J per m^3 of the reference configuration
};

}  // namespace kerf
