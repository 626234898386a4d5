// SPDX-License-Identifier: Apache-2.0
#include "simulation/plastic_media.hpp"

#include "simulation/levels.hpp"

namespace kerf {

namespace {

PlasticHeat<double> heat_of(const Material& material) {
  PlasticHeat<double> heat;
  heat.capacity = material.density * material.heat_capacity;
  heat.share = material.heat_share;
  heat.start_temperature = material.temperature;
  heat.reference_temperature = material.reference_temperature;
  heat.melting_temperature = material.melting_temperature;
  return heat;
}

JohnsonCookDamage<double> damage_of(const Material& material) {
  JohnsonCookDamage<double> damage;
  damage.constant = material.damage_d1;
  damage.triaxial = material.damage_d2;
  damage.triaxial_exponent = material.damage_d3;
  damage.rate_coefficient = material.damage_d4;
  damage.thermal_coefficient = material.damage_d5;
  damage.reference_rate = material.reference_rate;
  damage.least_failure_strain = material.least_plastic_failure;
  return damage;
}

PlasticParameters<double> parameters_of(const Material& material, int dimension) {
  PlasticParameters<double> parameters;
  parameters.law = material.plasticity;
  switch (material.plasticity) {
    case PlasticLaw::none:
      break;
    case PlasticLaw::von_mises:
      parameters.hardening = {material.yield_strength, material.hardening_modulus,
                              material.saturation_stress, material.saturation_strain};
      break;
    case PlasticLaw::johnson_cook:
      parameters.strength = {material.yield_strength,     material.hardening_coefficient,
                             material.hardening_exponent, material.rate_coefficient,
                             material.reference_rate,     material.thermal_exponent};
      break;
    case PlasticLaw::drucker_prager:
      parameters.cone = DruckerPrager<double>::of(
          material.cohesion, material.friction_angle, material.dilation_angle,
          material.tension_cut_off,
          dimension == 2 ? ConeMatch::plane_strain : ConeMatch::compression);
      break;
  }
  if (!parameters.flows() || !parameters.is_metal()) return parameters;
  parameters.heat = heat_of(material);
  parameters.damage = damage_of(material);
  return parameters;
}

}  // namespace

std::vector<PlasticParameters<double>> make_plastic_media(const Case& description) {
  std::vector<PlasticParameters<double>> laws;
  for (const auto [source, level] : medium_origins(description)) {
    const bool elastic =
        source < description.bodies.size() && description.bodies[source].role == Role::elastic;
    laws.push_back(elastic ? parameters_of(description.materials.at(static_cast<std::size_t>(
                                               description.bodies[source].material)),
                                           description.dimension)
                           : PlasticParameters<double>{});
  }
  return laws;
}

}  // namespace kerf
