// SPDX-License-Identifier: Apache-2.0
// A solid that flows has Hencky's energy of the elastic part of its deformation,
//   psi = G dev(e) : dev(e) + K/2 (tr e)^2,   e = 1/2 ln b_e,   b_e = F C_p^-1 F^T,
//   Kirchhoff stress  tau = J sigma = 2 G dev(e) + K tr(e),
// with K and G independent (Anand, J. Appl. Mech. 46 (1979) 78). In principal axes strains of
// successive stretches add up, which makes plastic flow as simple as at small strain (Weber &
// Anand, Comput. Methods Appl. Mech. Engrg. 79 (1990) 173; Simo, ibid. 99 (1992) 61).
#pragma once

#include <cmath>

#include "core/principal_frame.hpp"
#include "materials/elastic_moduli.hpp"
#include "materials/finite_strain.hpp"
#include "materials/push_forward.hpp"

namespace kerf {

// The elastic strain e, in principal axes of the current configuration.
template <int D, class T>
struct ElasticStrain {
  PrincipalFrame<D, T> stretch;  // of b_e - 1
  Vector<3, T> deviator;         // dev(e)
  T volume;                      // tr(e) = ln(J_e)

  // The strain at the displacement gradient H = F - 1 and the plastic metric A = C_p^-1 - 1:
  //   b_e - 1 = H + H^T + H H^T + F A F^T.
  KERF_FUNCTION static ElasticStrain of(const Matrix<D, T>& h,
                                        const SymmetricTensor<D, T>& metric) {
    auto excess = congruence(identity<D, T>() + h, metric);
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) {
        T square = T(0);
        for (int c = 0; c < D; ++c) square += h(a, c) * h(b, c);
        excess(a, b) += h(a, b) + h(b, a) + square;
      }
    ElasticStrain strain;
    strain.stretch = PrincipalFrame<D, T>::of(excess);
    for (int a = 0; a < 3; ++a) strain.deviator[a] = T(0.5) * std::log1p(strain.stretch.value[a]);
    strain.volume = strain.deviator[0] + strain.deviator[1] + strain.deviator[2];
    for (int a = 0; a < 3; ++a) strain.deviator[a] -= strain.volume / T(3);
    return strain;
  }

  // psi, J per m^3 of the reference configuration.
  KERF_FUNCTION T energy_density(const ElasticModuli<T>& solid) const {
    return solid.shear_modulus * dot(deviator, deviator) +
           T(0.5) * solid.bulk_modulus * volume * volume;
  }
  // Of the Kirchhoff stress, Pa: q = sqrt(3/2 s : s), and the mean, tension positive.
  KERF_FUNCTION T equivalent_stress(const ElasticModuli<T>& solid) const {
    return T(2) * solid.shear_modulus * std::sqrt(T(1.5) * dot(deviator, deviator));
  }
  KERF_FUNCTION T mean_stress(const ElasticModuli<T>& solid) const {
    return solid.bulk_modulus * volume;
  }

  KERF_FUNCTION SymmetricTensor<D, T> kirchhoff(const ElasticModuli<T>& solid) const {
    Vector<3, T> stress = T(2) * solid.shear_modulus * deviator;
    for (int a = 0; a < 3; ++a) stress[a] += mean_stress(solid);
    return stretch.tensor(stress);
  }
};

// ln J of the total deformation.
template <int D, class T>
KERF_FUNCTION T log_volume(const Matrix<D, T>& h) {
  return T(0.5) * std::log1p(volume_square_less_one(green_strain(h)));
}

}  // namespace kerf
