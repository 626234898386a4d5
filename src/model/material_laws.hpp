// SPDX-License-Identifier: Apache-2.0
// The parameters that a case gives the laws of a material: each law keeps them in a structure of
// its own. Code that only chooses among laws includes model/material.hpp.
#pragma once

#include "fracture/bond_criterion.hpp"
#include "materials/equation_of_state.hpp"
#include "materials/plastic_law.hpp"
#include "model/material.hpp"

namespace kerf {

struct MaterialLaws : ElasticLawSet<double>, BondCriterionSet<double>, EquationOfStateSet<double> {
  StrengthRate<double> strength_rate;       // of the fracture criterion
  CompressiveStrength<double> compression;  // of a criterion that softens
  PlasticLawSet<double> plastic;
  JohnsonCookDamage<double> damage;  // of metals
  PlasticHeat<double> heat;          // of metals

  bool operator==(const MaterialLaws&) const = default;
};

// The plastic law of a material with its parameters.
PlasticParameters<double> plastic_parameters(const Material& material);
// The criterion of a solid for which none is named. A fracture energy alone has no strain, and its
// cracks must not follow the lattice (docs/theory/softening.md, brittle limit); a solid that flows
// cannot soften.
BondCriterion default_criterion(bool has_energy_alone, PlasticLaw plasticity);
// The strains at which a material begins to fail and has failed, at a spacing in m, and what
// pressure adds to its strength.
FractureLimits fracture_limits(const Material& material, double spacing);

}  // namespace kerf
