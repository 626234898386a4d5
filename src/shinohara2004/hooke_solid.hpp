// SPDX-License-Identifier: Apache-2.0
// Elastic solid of Shinohara et al. (2004): pressure by eq. (32), p = K (rho/rho_0 - 1), and
// deviatoric stress by Hooke's law with the Jaumann rate, eqs. (34) to (37),
//   ds/dt = 2 G (e - tr(e)/3) + s w^T + w s,   e, w = symmetric, skew part of the velocity
//   gradient.
// A fractured particle carries compression only: p >= 0 and s = 0 (section 2.3).
#pragma once

#include <cmath>

#include "core/tensor.hpp"
#include "model/medium.hpp"

namespace kerf {

struct HookeSolid {
  template <class T>
  KERF_FUNCTION static T pressure(const Medium<T>& solid, T compression, bool fractured) {  // Pa
    const T p = solid.bulk_modulus * compression;
    return fractured && p < T(0) ? T(0) : p;
  }

  // Rate of the deviatoric stress, Pa/s. In plane strain d v_z/dz = 0, but s_zz has a rate.
  template <int D, class T>
  KERF_FUNCTION static SymmetricTensor<D, T> shear_rate(const Medium<T>& solid,
                                                        const SymmetricTensor<D, T>& s,
                                                        const Matrix<D, T>& gradient,
                                                        const SkewTensor<D, T>& spin) {
    SymmetricTensor<D, T> rate = SymmetricTensor<D, T>::zero();
    const T two_g = T(2) * solid.shear_modulus;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) {
        rate(a, b) += two_g * T(0.5) * (gradient(a, b) + gradient(b, a));
        // The term s_ag w_bg + s_gb w_ag of eq. (34).
        for (int g = 0; g < D; ++g) rate(a, b) += s(a, g) * spin(b, g) + s(g, b) * spin(a, g);
      }
    const T mean = two_g * gradient.trace() / T(3);
    for (int a = 0; a < 3; ++a) rate(a, a) -= mean;
    return rate;
  }

  // Stored energy per mass, J/kg. Volumetric: the integral of p / rho^2 d rho.
  template <class T>
  KERF_FUNCTION static double volumetric_energy(const Medium<T>& solid, double compression,
                                                bool fractured) {
    if (fractured && compression < 0.0) return 0.0;
    const double ratio = 1.0 + compression;
    return static_cast<double>(solid.bulk_modulus) / solid.density *
           (std::log(ratio) + 1.0 / ratio - 1.0);
  }
  // Deviatoric: s : s / (4 G rho).
  template <int D, class T>
  KERF_FUNCTION static double deviatoric_energy(const Medium<T>& solid,
                                                const SymmetricTensor<D, T>& s,
                                                double compression) {
    const double square = static_cast<double>(contract(s, s));
    return square / (4.0 * solid.shear_modulus * solid.density * (1.0 + compression));
  }
};

}  // namespace kerf
