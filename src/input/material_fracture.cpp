// SPDX-License-Identifier: Apache-2.0
#include "input/material_fracture.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "fracture/bond_criterion.hpp"
#include "fracture/compressive_strength.hpp"
#include "input/material_library.hpp"
#include "input/section.hpp"
#include "input/units.hpp"
#include "model/law_keys.hpp"
#include "model/material_laws.hpp"

namespace kerf {

namespace {

// A zero is no limit; a case file that Kerf wrote has it.
void refuse_key(Section& section, const char* key, double value, const Material& material) {
  if (!section.has(key) || value == 0.0) return;
  const auto word = word_of(material.criterion, bond_criterion_words);
  section.refuse(
      key, fmt::format("the criterion uses {}", keys_of(material.criterion).compared_quantity),
      "Remove the key, or choose another criterion",
      fmt::format("nothing beside the criterion \"{}\"", word));
}

// A value that cannot be read, which has a problem, is 0 too.
void require_key(Section& section, const char* key, double value, const Material& material) {
  const auto word = word_of(material.criterion, bond_criterion_words);
  if (value == 0.0 && !section.reading().problems.concern(section.path(key)))
    section.refuse(key, fmt::format("the criterion \"{}\" needs it", word), "Add it",
                   "greater than 0");
}

// Whether the energy is the only limit: a strain of the base gives way to an energy of the case.
bool has_energy_alone(const Section& section, const Material& material) {
  const bool has_strain = material.failure_strain > 0.0 &&
                          (section.has("failure_strain") || !section.has("fracture_energy"));
  return material.fracture_energy > 0.0 && !has_strain;
}

// Of two limits that a base with another criterion has, one stays: the one that the case gives,
// else the energy, which has a length scale.
void choose_limit(const Section& section, Material& material) {
  if (section.has("fracture_energy") || material.fracture_energy == 0.0) return;
  const bool by_strain = section.has("failure_strain") && material.failure_strain > 0.0;
  (by_strain ? material.fracture_energy : material.failure_strain) = 0.0;
}

// Refuses a strain beside an energy under a criterion that uses one of them.
void refuse_both(Section& section, const Material& material) {
  constexpr BondCriterion banded = BondCriterion::crack_band;
  const bool may_have_both =
      material.plasticity == PlasticLaw::none || !keys_of(banded).excludes_plasticity;
  const std::string with = fmt::format("criterion = \"{}\"", word_of(banded, bond_criterion_words));
  section.refuse("fracture_energy", "a failure_strain is given as well",
                 may_have_both
                     ? fmt::format("Add {}, which uses both: damage begins at the strain, "
                                   "and the crack takes the energy; or remove one",
                                   with)
                     : std::string("Remove one of the two"),
                 fmt::format("one of failure_strain and fracture_energy{}",
                             may_have_both ? ", or both with " + with : std::string()));
}

// Checks the fracture energy, which replaces a failure strain.
void resolve_energy(Section& section, Formulation formulation, Material& material) {
  choose_limit(section, material);
  if (!section.has("fracture_energy") || material.fracture_energy == 0.0) return;
  if (formulation != Formulation::standard)
    section.refuse("fracture_energy", "this formulation breaks particles at a strain",
                   "Give a failure_strain, or choose formulation = \"standard\"");
  if (section.has("failure_strain") && material.failure_strain > 0.0)
    refuse_both(section, material);
  material.failure_strain = 0.0;
}

// Checks the failure strain and the fracture energy against the needs of the criterion.
void resolve_limits(Section& section, Formulation formulation, Material& material) {
  const CriterionKeys keys = keys_of(material.criterion);
  switch (keys.limit) {
    case StrainOrEnergy::one_of_them:
      resolve_energy(section, formulation, material);
      break;
    case StrainOrEnergy::both:
      require_key(section, "failure_strain", material.failure_strain, material);
      require_key(section, "fracture_energy", material.fracture_energy, material);
      break;
    case StrainOrEnergy::energy:
      require_key(section, "fracture_energy", material.fracture_energy, material);
      refuse_key(section, "failure_strain", material.failure_strain, material);
      material.failure_strain = 0.0;
      break;
    case StrainOrEnergy::neither:
      refuse_key(section, "failure_strain", material.failure_strain, material);
      refuse_key(section, "fracture_energy", material.fracture_energy, material);
      material.failure_strain = material.fracture_energy = 0.0;
      break;
  }
  if (keys.excludes_plasticity && material.plasticity != PlasticLaw::none)
    section.refuse("criterion", "the material flows",
                   "Choose another criterion, or plasticity = \"none\"",
                   fmt::format("\"{}\" where plasticity is \"none\"",
                               word_of(material.criterion, bond_criterion_words)));
}

// Refuses coefficients of the damage of metals that nothing switches on.
void resolve_damage(Section& section, const Material& material) {
  const JohnsonCookDamage<double>& damage = material.laws->damage;
  if (damage.is_on() || section.reading().problems.concern(section.path("least_plastic_failure")))
    return;
  const std::pair<const char*, double> values[] = {{"damage_d1", damage.constant},
                                                   {"damage_d2", damage.triaxial},
                                                   {"damage_d3", damage.triaxial_exponent},
                                                   {"damage_d4", damage.rate_coefficient},
                                                   {"damage_d5", damage.thermal_coefficient}};
  for (const auto& [key, value] : values) {
    if (!section.has(key) || value == 0.0) continue;
    section.refuse(key, "without a least_plastic_failure no damage grows",
                   "Add least_plastic_failure, such as 0.01: the plastic strain at failure is not "
                   "below it, however great the tension",
                   "0, or a value beside a least_plastic_failure above 0");
    return;
  }
}

// Checks a compressive strength that the case states. That of the library, where a case gives it
// another tensile strength, counts as far as it is more than that of shear.
void resolve_compression(Section& section, const Material& material) {
  const CompressiveStrength<double>& compression = material.laws->compression;
  if (!compression.is_on() || !section.has("compressive_strength")) return;
  const auto moduli = ElasticModuli<double>::of(material.youngs_modulus, material.poisson_ratio);
  if (bond_bulk_modulus(moduli.bulk_modulus, moduli.shear_modulus) < moduli.bulk_modulus) {
    section.refuse(
        "compressive_strength",
        fmt::format("at a poisson_ratio of {:g} the density of the solid bears most of a "
                    "pressure, and its bonds fail by shear",
                    material.poisson_ratio),
        "Remove the key, or give a poisson_ratio of 0.41 or less",
        "0 Pa where the poisson_ratio is above 0.41");
    return;
  }
  const double least =
      least_compressive_ratio(moduli) * material.youngs_modulus * material.failure_strain;
  if (compression.compressive_strength >= least) return;
  section.refuse("compressive_strength",
                 "the energy of shear alone bears more before the failure_strain is reached",
                 "Give the strength of a compressive test, or remove the key",
                 fmt::format("0 Pa, or {} or more", show_quantity(least, "Pa", Bound::least)));
}

// Checks the rate of strain on which strength depends.
void resolve_strength_rate(Section& section, const Material& material) {
  const StrengthRate<double>& rate = material.laws->strength_rate;
  if (!rate.is_on()) return;
  if (material.plasticity != PlasticLaw::none)
    section.refuse("strength_rate_exponent", "the material flows",
                   "Remove the key; the rate of a flowing material is that of johnson_cook",
                   "0 where plasticity is not \"none\"");
  if (rate.reference_rate == 0.0 &&
      section.reading().problems.concern(section.path("strength_reference_rate")))
    return;
  if (rate.reference_rate == 0.0)
    section.refuse("strength_reference_rate", "a strength_rate_exponent needs it",
                   "Add the rate of strain of the tests that gave the limits",
                   "greater than 0 s-1");
  else if (rate.greatest_rate <= rate.reference_rate)
    section.refuse("strength_greatest_rate", "strength would not depend on the rate",
                   "Give a rate above the strength_reference_rate, or remove the key",
                   fmt::format("above {:g} s-1", rate.reference_rate));
}

}  // namespace

void choose_criterion(const Section& section, const LibraryMaterial* base, Formulation formulation,
                      Material& material) {
  const bool is_named = section.has("criterion") || (base && base->criterion);
  if (is_named || formulation != Formulation::standard || material.kind != MaterialKind::elastic)
    return;
  material.criterion = default_criterion(has_energy_alone(section, material), material.plasticity);
}

void resolve_fracture(Section& section, Formulation formulation, Material& material) {
  resolve_limits(section, formulation, material);
  resolve_damage(section, material);
  resolve_compression(section, material);
  resolve_strength_rate(section, material);
}

}  // namespace kerf
