// SPDX-License-Identifier: Apache-2.0
// The two moduli of an isotropic elastic solid. The nearer a solid is to incompressible, the less
// of its bulk modulus is carried by its bonds; the rest acts by the density
// (docs/theory/nearly_incompressible.md).
#pragma once

#include "core/host_device.hpp"

namespace kerf {

template <class T>
struct ElasticModuli {
  T bulk_modulus = 0;   // K, Pa
  T shear_modulus = 0;  // G, Pa

  // From Young's modulus, Pa, and Poisson's ratio.
  static ElasticModuli of(T young, T poisson_ratio) {
    return {young / (T(3) * (T(1) - T(2) * poisson_ratio)),
            young / (T(2) * (T(1) + poisson_ratio))};
  }
  KERF_FUNCTION T young_modulus() const {  // Pa
    return T(9) * bulk_modulus * shear_modulus / (T(3) * bulk_modulus + shear_modulus);
  }
  KERF_FUNCTION T lame() const {  // lambda = K - 2 G / 3, Pa
    return bulk_modulus - T(2) / T(3) * shear_modulus;
  }
};

inline constexpr double most_bond_bulk = 5.0;  // K / G, nu = 0.41

// The bulk modulus that the bonds of a solid carry, Pa.
inline double bond_bulk_modulus(double bulk_modulus, double shear_modulus) {
  const double most = most_bond_bulk * shear_modulus;
  return bulk_modulus < most ? bulk_modulus : most;
}

inline constexpr double most_tensile_bulk = 50.0;  // K / G, nu = 0.49

// The part of the bulk modulus that acts by the density where an undamaged solid expands, Pa.
inline double tensile_excess_modulus(double bulk_modulus, double shear_modulus) {
  const double most = most_tensile_bulk * shear_modulus;
  return (bulk_modulus < most ? bulk_modulus : most) -
         bond_bulk_modulus(bulk_modulus, shear_modulus);
}

}  // namespace kerf
