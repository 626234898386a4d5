// SPDX-License-Identifier: Apache-2.0
#include "model/material_laws.hpp"

namespace kerf {

LawParameters::LawParameters() : laws_(std::make_unique<MaterialLaws>()) {}
LawParameters::LawParameters(const LawParameters& other)
    : laws_(std::make_unique<MaterialLaws>(*other)) {}
LawParameters::LawParameters(LawParameters&& other) noexcept = default;
LawParameters& LawParameters::operator=(const LawParameters& other) {
  return *this = LawParameters(other);
}
LawParameters& LawParameters::operator=(LawParameters&& other) noexcept = default;
LawParameters::~LawParameters() = default;
bool LawParameters::operator==(const LawParameters& other) const {
  return **this == *other;
}

PlasticParameters<double> plastic_parameters(const Material& material) {
  PlasticParameters<double> parameters;
  static_cast<PlasticLawSet<double>&>(parameters) = material.laws->plastic;
  parameters.law = material.plasticity;
  parameters.damage = material.laws->damage;
  parameters.heat = material.laws->heat;
  return parameters;
}

BondCriterion default_criterion(bool has_energy_alone, PlasticLaw plasticity) {
  const bool is_brittle = has_energy_alone && plasticity == PlasticLaw::none;
  return is_brittle ? BondCriterion::brittle_band : BondCriterion::principal_strain;
}

FractureLimits fracture_limits(const Material& material, double spacing) {
  const auto moduli = ElasticModuli<double>::of(material.youngs_modulus, material.poisson_ratio);
  const FractureInput input{moduli, material.failure_strain, material.fracture_energy, spacing};
  FractureLimits limits = BondCriterionSet<double>::visit(
      *material.laws, material.criterion, [&](const auto& chosen) { return chosen.limits(input); });
  const CompressiveStrength<double>& compression = material.laws->compression;
  if (compression.is_on() && limits.start > 0.0)
    limits.confinement = confinement_of(
        moduli, compression.compressive_strength / (moduli.young_modulus() * limits.start));
  return limits;
}

bool Material::can_break() const {
  const bool has_limit = failure_strain > 0.0 || fracture_energy > 0.0;
  return can_break_bonds(*laws, criterion, has_limit) || plastic_parameters(*this).can_break();
}

}  // namespace kerf
