// SPDX-License-Identifier: Apache-2.0
// The crack band relates the fracture energy of a material to the strains at which a particle of a
// given spacing begins to fail and has failed, so that the energy of a crack does not depend on the
// spacing; both strains are equal where the material is brittle. The criterion that is called
// crack_band in cases is fracture/crack_band_criterion.hpp.
#pragma once

#include <cmath>

#include "materials/elastic_moduli.hpp"

namespace kerf {

// What a case gives of a material's limits, and the spacing of its particles.
struct FractureInput {
  ElasticModuli<double> moduli;  // of the material
  double failure_strain = 0.0;   // 1; 0 = none
  double fracture_energy = 0.0;  // Gc, J/m^2; 0 = none
  double spacing = 0.0;          // d, m
};

// Strains below this are lost in the rounding of deformation gradients in single precision; a limit
// below it would break nothing or everything.
inline constexpr double least_failure_strain = 1e-6;

struct FractureLimits {
  double start = 0.0, end = 0.0;  // e_0 and e_f, 1; 0 = never
  double confinement = 0.0;       // c of compressive_strength.hpp, 1
  bool softens() const { return end > start; }
};

// A crack takes, per area, the energy that a band beside it has stored at the failure strain (crack
// band: Bazant & Oh, Materiaux et Constructions 16 (1983) 155). The band is strained across the
// crack only, and the material cannot contract along it, so its stiffness is the P-wave modulus M:
//   Gc = w d M strain^2 / 2,   M = K + 4 G / 3 of what bonds carry,
// so that the energy of a crack is the material's, and the strain is proportional to 1 / sqrt(d). w
// is such that a wide strip breaks at its Gc: 3.1 to 3.3 for nu = 0 and 0.3, on a lattice and off
// it, once the strip is 17 spacings high or more (tests/unit/solid/crack_band_test.cpp).
inline constexpr double brittle_band_width = 3.2;  // w of a brittle material, spacings

// The failure strain of a fracture energy; K and G of the material in Pa, energy in J/m^2, spacing
// in m.
inline double failure_strain_of(double fracture_energy, double bulk_modulus, double shear_modulus,
                                double spacing) {
  const double modulus = bond_bulk_modulus(bulk_modulus, shear_modulus) + 4.0 / 3.0 * shear_modulus;
  return std::sqrt(2.0 * fracture_energy / (brittle_band_width * spacing * modulus));
}

// Where a band softens from a strain on (fracture/softening.hpp),  Gc = w d E e_0 e_f / 2.  A band
// that is too wide for that breaks at the strain e_0 = e_f that makes the energy right, below the
// material's (Bazant & Oh, section 7). w is such that a strip that is slowly pulled in two takes
// its Gc: 2.6 to 2.8 for nu = 0 and 0.3, e_f from 3 to 12 e_0, on a lattice and off it
// (tests/unit/solid/softening_test.cpp).
inline constexpr double softening_band_width = 2.65;  // w of a softening band, spacings

// E in Pa, energy in J/m^2, spacing in m; strain: that at which the material begins to fail.
inline FractureLimits softening_law_of(double fracture_energy, double youngs_modulus, double strain,
                                       double spacing) {
  const double end =
      2.0 * fracture_energy / (softening_band_width * spacing * youngs_modulus * strain);
  if (end > strain) return {strain, end};
  const double brittle = std::sqrt(end * strain);
  return {brittle, brittle};
}

// Young's modulus that bonds carry, Pa.
inline double carried_youngs_modulus(const ElasticModuli<double>& moduli) {
  const double carried = bond_bulk_modulus(moduli.bulk_modulus, moduli.shear_modulus);
  return ElasticModuli<double>{carried, moduli.shear_modulus}.young_modulus();
}

// e_f / e_0 of a material without a strength of its own. A crack that breaks its bonds at one
// strain is held by the rows of the lattice and follows them. Softening spreads its tip over
// several particles; below 5 cracks along a row and between two rows still start at loads that
// differ by more than a tenth (tests/unit/solid/crack_direction_test.cpp).
inline constexpr double brittle_softening = 6.0;

// The brittle limit of the crack band: the strength follows from the energy and the spacing,
//   Gc = w d E e_0 e_f / 2,   e_f / e_0 = brittle_softening.
inline FractureLimits brittle_band_of(double fracture_energy, double youngs_modulus,
                                      double spacing) {
  const double start =
      std::sqrt(2.0 * fracture_energy /
                (softening_band_width * spacing * youngs_modulus * brittle_softening));
  return {start, brittle_softening * start};
}

// The limits of a material that breaks at once: its failure strain, or that of its fracture energy.
inline FractureLimits brittle_limits(const FractureInput& input) {
  const double limit = input.fracture_energy > 0.0
                           ? failure_strain_of(input.fracture_energy, input.moduli.bulk_modulus,
                                               input.moduli.shear_modulus, input.spacing)
                           : input.failure_strain;
  return {limit, limit};
}

}  // namespace kerf
