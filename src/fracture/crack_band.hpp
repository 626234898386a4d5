// SPDX-License-Identifier: Apache-2.0
// The strain at which a material of given fracture energy breaks. A crack needs, per area, what a
// band beside it has stored at that strain (crack band: Bazant & Oh, Materiaux et Constructions 16
// (1983) 155), and beside a crack that opens nothing can give way along it:
//   Gc = w d M strain^2 / 2,   M = K + 4 G / 3 of what bonds carry,   d: spacing,
// so that the energy of a crack is the material's, and the strain goes with 1 / sqrt(d). w is such
// that a wide strip tears at its Gc: 3.1 to 3.3 for nu = 0 and 0.3, on a lattice and off it, once
// the strip is 17 spacings high or more (tests/unit/solid/crack_band_test.cpp).
#pragma once

#include <cmath>

#include "materials/bond_bulk.hpp"

namespace kerf {

inline constexpr double crack_band_width = 3.2;  // w, spacings

// K and G of the material in Pa, energy in J/m^2, spacing in m.
inline double failure_strain_of(double fracture_energy, double bulk_modulus, double shear_modulus,
                                double spacing) {
  const double modulus = bond_bulk_modulus(bulk_modulus, shear_modulus) + 4.0 / 3.0 * shear_modulus;
  return std::sqrt(2.0 * fracture_energy / (crack_band_width * spacing * modulus));
}

}  // namespace kerf
