// SPDX-License-Identifier: Apache-2.0
// What all particles of one solid share, as the loops over its bonds need it.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/mirror_planes.hpp"
#include "exec/host_device.hpp"
#include "materials/laws.hpp"

namespace kerf {

template <class T>
struct SolidMedium {
  ElasticLaw law = ElasticLaw::neo_hookean;
  BondCriterion criterion = BondCriterion::principal_strain;
  std::uint16_t piece = 0;        // particles of one piece hold together
  MirrorCode joined_mirrors = 0;  // planes beyond which the mirror image is of the same piece
  T density = 0;                  // kg/m^3, reference
  T spacing = 0;                  // m
  T smoothing_length = 0;         // m
  T mass = 0;                     // kg per particle (2D: kg/m)
  T bulk_modulus = 0;             // Pa
  T shear_modulus = 0;            // Pa
  T hourglass = T(0.5);           // zeta; 0 = no control. The reason for 0.5: docs/theory
  T artificial_linear = 0;        // A of the bond viscosity
  T artificial_quadratic = 0;     // B of the bond viscosity
  T failure_strain = 0;           // 1, Hencky (logarithmic); 0 = never breaks
  T softening_strain = 0;         // 1, where softening begins (softening.hpp); 0 = brittle
  T tensile_strength = 0;         // Pa, of the criterion principal_stress; 0 = never breaks

  KERF_FUNCTION T volume() const { return mass / density; }  // m^3 (2D: m^2), reference
  KERF_FUNCTION T young_modulus() const {                    // Pa
    return T(9) * bulk_modulus * shear_modulus / (T(3) * bulk_modulus + shear_modulus);
  }
  KERF_FUNCTION bool can_break() const {
    if (criterion == BondCriterion::grady_kipp) return true;
    return criterion == BondCriterion::principal_stress ? tensile_strength > T(0)
                                                        : failure_strain > T(0);
  }
  // Whether this strain of a place passes the limit, if there is one.
  KERF_FUNCTION bool fails_at(T strain) const {
    return failure_strain > T(0) && strain > failure_strain;
  }
  KERF_FUNCTION bool softens() const { return softening_strain > T(0); }
  // Modulus of the hourglass control, Pa.
  KERF_FUNCTION T hourglass_modulus() const { return hourglass * young_modulus(); }
  // Fastest wave, m/s.
  KERF_FUNCTION T longitudinal_speed() const {
    return std::sqrt((bulk_modulus + T(4) / T(3) * shear_modulus) / density);
  }

  template <class Other>
  KERF_FUNCTION static SolidMedium from(const SolidMedium<Other>& other) {
    SolidMedium medium;
    medium.law = other.law;
    medium.criterion = other.criterion;
    medium.piece = other.piece;
    medium.joined_mirrors = other.joined_mirrors;
    medium.density = static_cast<T>(other.density);
    medium.spacing = static_cast<T>(other.spacing);
    medium.smoothing_length = static_cast<T>(other.smoothing_length);
    medium.mass = static_cast<T>(other.mass);
    medium.bulk_modulus = static_cast<T>(other.bulk_modulus);
    medium.shear_modulus = static_cast<T>(other.shear_modulus);
    medium.hourglass = static_cast<T>(other.hourglass);
    medium.artificial_linear = static_cast<T>(other.artificial_linear);
    medium.artificial_quadratic = static_cast<T>(other.artificial_quadratic);
    medium.failure_strain = static_cast<T>(other.failure_strain);
    medium.softening_strain = static_cast<T>(other.softening_strain);
    medium.tensile_strength = static_cast<T>(other.tensile_strength);
    return medium;
  }
};

}  // namespace kerf
