// SPDX-License-Identifier: Apache-2.0
// How much of a solid's bulk modulus its bonds carry; the rest acts by the density
// (docs/theory/nearly_incompressible.md).
#pragma once

namespace kerf {

inline constexpr double most_bond_bulk = 5.0;  // K / G, nu = 0.41

// Pa.
inline double bond_bulk_modulus(double bulk_modulus, double shear_modulus) {
  const double most = most_bond_bulk * shear_modulus;
  return bulk_modulus < most ? bulk_modulus : most;
}

}  // namespace kerf
