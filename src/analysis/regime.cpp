// SPDX-License-Identifier: Apache-2.0
#include "analysis/regime.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/derived.hpp"
#include "model/material_laws.hpp"

namespace kerf {
namespace {

// Returns the tensile stress, Pa, at which a criterion that is not one of strain begins to break a
// solid; 0 where there is none. Flaws have one active flaw per volume of a particle in the mean.
struct StressLimit {
  const Material& solid;
  const SolidScale& scale;
  template <class Criterion>
  double operator()(const Criterion& criterion) const {
    if constexpr (requires { criterion.tensile_strength; }) return criterion.tensile_strength;
    if constexpr (requires { criterion.weibull_k; }) {
      const double depth = scale.dimension == 2 ? criterion.flaw_depth : 1.0;
      const double flaws = criterion.weibull_k * std::pow(scale.spacing, scale.dimension) * depth;
      if (flaws > 0.0) return solid.youngs_modulus * std::pow(flaws, -1.0 / criterion.weibull_m);
    }
    return 0.0;
  }
};

}  // namespace

double resistance_of(const Material& solid, const SolidScale& scale) {
  double resistance =
      2.5 * ElasticModuli<double>::of(solid.youngs_modulus, solid.poisson_ratio).shear_modulus;
  for (const double limit :
       {solid.youngs_modulus * scale.failure_strain, plastic_parameters(solid).first_strength(),
        BondCriterionSet<double>::visit(*solid.laws, solid.criterion, StressLimit{solid, scale})})
    if (limit > 0.0) resistance = std::min(resistance, limit);
  return resistance;
}

std::string regime_of(const DerivedNumbers& numbers) {
  if (numbers.stagnation_pressure < numbers.resistance) return "elastic dimple";
  if (numbers.hydrodynamic_front_speed < numbers.rayleigh_speed) return "crack-led";
  if (numbers.hydrodynamic_front_speed <= numbers.longitudinal_speed) return "erosion";
  return "hydrodynamic";
}

}  // namespace kerf
