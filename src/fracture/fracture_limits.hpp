// SPDX-License-Identifier: Apache-2.0
// The strains at which a material of a case begins to fail and is through, at a spacing: the same
// where it is brittle, both 0 where it never fails by a strain or an energy.
#pragma once

#include "case/material.hpp"
#include "fracture/crack_band.hpp"
#include "fracture/softening_band.hpp"

namespace kerf {

inline SofteningBand fracture_limits(const Material& material, double spacing) {
  const double e = material.youngs_modulus, nu = material.poisson_ratio;
  const double bulk = e / (3.0 * (1.0 - 2.0 * nu)), shear = e / (2.0 * (1.0 + nu));
  if (material.criterion == BondCriterion::crack_band) {
    const double carried = bond_bulk_modulus(bulk, shear);
    return softening_of(material.fracture_energy, 9.0 * carried * shear / (3.0 * carried + shear),
                        material.failure_strain, spacing);
  }
  const double limit = material.fracture_energy > 0.0
                           ? failure_strain_of(material.fracture_energy, bulk, shear, spacing)
                           : material.failure_strain;
  return {limit, limit};
}

// Whether anything in it ends: a strain, an energy, a stress, flaws, or damage of a metal.
inline bool can_break(const Material& material) {
  if (material.criterion == BondCriterion::grady_kipp || material.least_plastic_failure > 0.0)
    return true;
  return material.criterion == BondCriterion::principal_stress
             ? material.tensile_strength > 0.0
             : material.failure_strain > 0.0 || material.fracture_energy > 0.0;
}

}  // namespace kerf
