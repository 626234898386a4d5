// SPDX-License-Identifier: Apache-2.0
// The return mapping computes the plastic flow of a step by the backward Euler rule along an
// exponential map in principal axes (Simo, Comput. Methods Appl. Mech. Engrg. 99 (1992) 61; de
// Souza Neto, Peric & Owen, Computational Methods for Plasticity (2008), chapter 14). The step is
// first taken as elastic. If that stress exceeds the strength, the solid flows along the deviator
// of the stress and, if the law requires it, in volume:
//   e = e_trial - shear (3/2) s/q - volume/3 1,   q = q_trial - 3 G shear,
//   p = p_trial - K volume.
#pragma once

#include <limits>

#include "core/regula_falsi.hpp"
#include "materials/hencky.hpp"
#include "materials/plastic_heat.hpp"
#include "materials/plastic_state.hpp"

namespace kerf {

// A point of the meridian plane, Pa.
template <class T>
struct MeridianStress {
  T equivalent;  // q
  T mean;        // p, tension positive
};

template <class T>
struct PlasticFlow {
  T shear;   // sqrt(2/3 d : d) of the deviator d of the plastic strain of this step
  T volume;  // logarithmic

  KERF_FUNCTION static PlasticFlow none() { return {T(0), T(0)}; }
};

// The equivalent stress minus the strength after a flow of `shear`, with the rate and heat of that
// flow; its root is the flow of the step.
template <class T, class Law>
struct ExcessStress {
  const Law& law;
  const PlasticHeat<T>& heat;
  T trial;    // q_trial, Pa
  T modulus;  // 3 G, Pa
  T dt;       // s; 0 = slowly
  T plastic_strain, temperature_rise;

  KERF_FUNCTION T operator()(T shear) const {
    const T equivalent = trial - modulus * shear;
    const T rate = dt > T(0) ? shear / dt : T(0);
    const T homologous =
        heat.homologous_temperature(temperature_rise + heat.rise(equivalent * shear));
    return equivalent - law.strength(plastic_strain + shear, rate, homologous);
  }
};

// The flow of a metal, which keeps the volume. An excess within the rounding of its terms counts as
// zero.
template <class T, class Law>
KERF_FUNCTION PlasticFlow<T> metal_flow(const ExcessStress<T, Law>& excess) {
  const T accuracy = T(4) * std::numeric_limits<T>::epsilon() * excess.trial;
  return {regula_falsi(excess, excess.trial / excess.modulus, accuracy), T(0)};
}

// Subtracts the flow from the elastic strain and adds it to the metric:
//   A = A_trial + F^-1 (b_e - b_e_trial) F^-T.
// The difference of b_e is formed first, so that a small flow is not lost in rounding, and where
// there is no flow the metric keeps its last bit.
template <int D, class T>
KERF_FUNCTION void apply_flow(const PlasticFlow<T>& flow, const Matrix<D, T>& inverse_gradient,
                              ElasticStrain<D, T>& strain, SymmetricTensor<D, T>& metric) {
  const T size = std::sqrt(T(2) / T(3) * dot(strain.deviator, strain.deviator));
  T share = size > T(0) ? flow.shear / size : T(0);  // of the deviator
  if (share > T(1)) share = T(1);
  Vector<3, T> change;  // of b_e
  for (int a = 0; a < 3; ++a) {
    const T plastic = share * strain.deviator[a] + flow.volume / T(3);
    change[a] = (T(1) + strain.stretch.value[a]) * std::expm1(T(-2) * plastic);
  }
  metric += congruence(inverse_gradient, strain.stretch.tensor(change));
  for (int a = 0; a < 3; ++a) {
    strain.deviator[a] *= T(1) - share;
    strain.stretch.value[a] += change[a];
  }
  strain.volume -= flow.volume;
}

}  // namespace kerf
