// SPDX-License-Identifier: Apache-2.0
// The compressible neo-Hookean solid has a bulk modulus K independent of its shear modulus G,
//   psi = G/2 (J^(-2/3) tr C - 3) + K/2 [(J^2 - 1)/2 - ln J].
// The isochoric part does not depend on the volume (Flory, Trans. Faraday Soc. 57 (1961) 829); the
// volumetric part grows without bound as J goes to 0 and to infinity (Simo & Miehe, Comput. Methods
// Appl. Mech. Engrg. 98 (1992) 41). In Green's strain, C = 1 + 2 E:
//   S = dpsi/dE = G J^(-2/3) (C - tr C / 3) C^-1 + K/2 (J^2 - 1) C^-1.
#pragma once

#include <cmath>
#include <string_view>

#include "materials/elastic_moduli.hpp"
#include "materials/finite_strain.hpp"

namespace kerf {

template <class T>
struct NeoHookean {
  static constexpr std::string_view sentence =
      "Compressible neo-Hookean solid, for large strains of either sign";

  // psi, J/m^3.
  template <int D>
  KERF_FUNCTION T energy_density(const ElasticModuli<T>& moduli,
                                 const SymmetricTensor<D, T>& green) const {
    const T growth = volume_square_less_one(green);  // J^2 - 1
    const T log_square = std::log1p(growth);         // 2 ln J
    const T isochoric =
        T(3) * std::expm1(-log_square / T(3)) + T(2) * std::exp(-log_square / T(3)) * trace(green);
    return T(0.5) * moduli.shear_modulus * isochoric +
           T(0.25) * moduli.bulk_modulus * (growth - log_square);
  }

  // Second Piola-Kirchhoff stress, Pa.
  template <int D>
  KERF_FUNCTION SymmetricTensor<D, T> second_piola(const ElasticModuli<T>& moduli,
                                                   const SymmetricTensor<D, T>& green) const {
    const T growth = volume_square_less_one(green);
    SymmetricTensor<D, T> c = T(2) * green;
    SymmetricTensor<D, T> deviator = c;  // C - tr C / 3: the 1 of C drops out
    const T mean = trace(c) / T(3);
    for (int a = 0; a < 3; ++a) {
      deviator(a, a) -= mean;
      c(a, a) += T(1);
    }
    const SymmetricTensor<D, T> c_inverse = inverse(c);
    const T isochoric = moduli.shear_modulus / std::cbrt(T(1) + growth);
    return isochoric * coaxial_product(deviator, c_inverse) +
           (T(0.5) * moduli.bulk_modulus * growth) * c_inverse;
  }

  // Whether the part of the energy that K scales is one of expansion.
  template <int D>
  KERF_FUNCTION bool is_expanded(const SymmetricTensor<D, T>& green) const {
    return volume_square_less_one(green) > T(0);
  }

  template <class Other>
  KERF_FUNCTION static NeoHookean from(const NeoHookean<Other>&) {
    return {};
  }
  bool operator==(const NeoHookean&) const = default;
};

}  // namespace kerf
