// SPDX-License-Identifier: Apache-2.0
// The strain at which softening ends, so that a crack takes the material's energy.
#pragma once

#include <cmath>

namespace kerf {

// Where a band softens from a strain on (softening.hpp),  Gc = w d E e_0 e_f / 2.  A band that is
// too wide for that breaks at the strain e_0 = e_f that makes the energy right, below the
// material's (Bazant & Oh, section 7). w is such that a strip that is slowly pulled in two takes
// its Gc: 2.6 to 2.8 for nu = 0 and 0.3, e_f from 3 to 12 e_0, on a lattice and off it
// (tests/unit/solid/softening_test.cpp).
struct SofteningBand {
  double start = 0.0, end = 0.0;  // e_0 and e_f, 1
  bool softens() const { return end > start; }
};
inline constexpr double softening_band = 2.65;  // w, spacings

// E in Pa, energy in J/m^2, spacing in m; strain: that at which the material begins to fail.
inline SofteningBand softening_of(double fracture_energy, double youngs_modulus, double strain,
                                  double spacing) {
  const double end = 2.0 * fracture_energy / (softening_band * spacing * youngs_modulus * strain);
  if (end > strain) return {strain, end};
  const double brittle = std::sqrt(end * strain);
  return {brittle, brittle};
}

}  // namespace kerf
