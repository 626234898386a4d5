// SPDX-License-Identifier: Apache-2.0
#include "case/material_library.hpp"

#include "case/schema.hpp"

namespace kerf {

namespace {

constexpr MaterialField all_fields[] = {
    {"density", &Material::density},
    {"youngs_modulus", &Material::youngs_modulus},
    {"poisson_ratio", &Material::poisson_ratio},
    {"failure_strain", &Material::failure_strain},
    {"fracture_energy", &Material::fracture_energy},
    {"tensile_strength", &Material::tensile_strength},
    {"weibull_k", &Material::weibull_k},
    {"weibull_m", &Material::weibull_m},
    {"crack_speed_share", &Material::crack_speed_share},
    {"flaw_depth", &Material::flaw_depth},
    {"friction", &Material::friction},
    {"yield_strength", &Material::yield_strength},
    {"hardening_modulus", &Material::hardening_modulus},
    {"saturation_stress", &Material::saturation_stress},
    {"saturation_strain", &Material::saturation_strain},
    {"hardening_coefficient", &Material::hardening_coefficient},
    {"hardening_exponent", &Material::hardening_exponent},
    {"rate_coefficient", &Material::rate_coefficient},
    {"reference_rate", &Material::reference_rate},
    {"thermal_exponent", &Material::thermal_exponent},
    {"heat_capacity", &Material::heat_capacity},
    {"heat_share", &Material::heat_share},
    {"temperature", &Material::temperature},
    {"reference_temperature", &Material::reference_temperature},
    {"melting_temperature", &Material::melting_temperature},
    {"damage_d1", &Material::damage_d1},
    {"damage_d2", &Material::damage_d2},
    {"damage_d3", &Material::damage_d3},
    {"damage_d4", &Material::damage_d4},
    {"damage_d5", &Material::damage_d5},
    {"least_plastic_failure", &Material::least_plastic_failure},
    {"cohesion", &Material::cohesion},
    {"friction_angle", &Material::friction_angle},
    {"dilation_angle", &Material::dilation_angle},
    {"tension_cut_off", &Material::tension_cut_off},
    {"viscosity", &Material::viscosity},
    {"tait_exponent", &Material::tait_exponent},
    {"hugoniot_slope", &Material::hugoniot_slope},
    {"artificial_linear", &Material::artificial_linear},
    {"artificial_quadratic", &Material::artificial_quadratic},
    {"artificial_softening", &Material::artificial_softening},
};

constexpr KnownQuantity all_known[] = {
    {"tensile_strength", "Pa", "stress at which it breaks in tension"},
    {"compressive_strength", "Pa", "stress at which it breaks in compression"},
    {"spall_strength", "Pa", "tension that breaks it in a stress wave"},
    {"ultimate_strain", "", "strain at which it breaks in tension"},
    {"fracture_energy", "J/m2", "energy Gc of a crack per area"},
    {"yield_strength", "Pa", "stress at which it begins to flow"},
    {"power_law_coefficient", "Pa", "k of a power law k strain^n of plasticity"},
    {"power_law_exponent", "", "n of a power law k strain^n of plasticity"},
    {"johnson_cook_a", "Pa", "A of Johnson and Cook: yield stress"},
    {"johnson_cook_b", "Pa", "B of Johnson and Cook: hardening"},
    {"johnson_cook_n", "", "n of Johnson and Cook: exponent of hardening"},
    {"johnson_cook_c", "", "C of Johnson and Cook: rate"},
    {"johnson_cook_m", "", "m of Johnson and Cook: temperature"},
    {"cohesion", "Pa", "of Mohr and Coulomb"},
    {"friction_angle", "rad", "of Mohr and Coulomb"},
    {"weibull_k", "m-3", "k of the number of flaws k strain^m per volume"},
    {"weibull_m", "", "m of the number of flaws k strain^m per volume"},
    {"jet_threshold", "Pa", "pump pressure below which a plain water jet leaves it whole"},
};

}  // namespace

std::set<std::string> material_conditions(const Material& material, Formulation formulation) {
  std::set<std::string> conditions{kind_name(material.kind), formulation_name(formulation)};
  if (material.kind == MaterialKind::elastic) {
    conditions.emplace(word_of(material.plasticity, plastic_law_words));
    conditions.emplace(word_of(material.criterion, bond_criterion_words));
  }
  if (material.kind == MaterialKind::water)
    conditions.emplace(word_of(material.equation_of_state, equation_of_state_words));
  return conditions;
}

std::vector<MaterialField> material_fields(const std::set<std::string>& conditions) {
  std::vector<MaterialField> fields;
  for (const MaterialField& field : all_fields)
    if (find_key("materials", field.key, conditions)->applies_under(conditions))
      fields.push_back(field);
  return fields;
}

std::span<const KnownQuantity> known_quantities() {
  return all_known;
}

const LibraryValue* LibraryMaterial::find(std::string_view key) const {
  for (const LibraryValue& value : values)
    if (value.name == key) return &value;
  return nullptr;
}

std::set<std::string> LibraryMaterial::conditions() const {
  Material material;
  material.kind = kind;
  material.plasticity = plasticity;
  return material_conditions(material, Formulation::standard);
}

Material LibraryMaterial::material(Formulation formulation) const {
  Material result;
  result.name = name;
  result.kind = kind;
  if (formulation == Formulation::standard) result.plasticity = plasticity;
  result.source = "Kerf's library: " + title;
  const auto conditions = material_conditions(result, formulation);
  for (const MaterialField& field : material_fields(conditions)) {
    const LibraryValue* given = find(field.key);
    const Key* key = find_key("materials", field.key, conditions);
    result.*field.member = given ? given->value : standard_number(*key);
  }
  return result;
}

std::span<const LibraryMaterial> material_library() {
  static const std::vector<LibraryMaterial> library = [] {
    std::vector<LibraryMaterial> all;
    for (const EmbeddedText& file : material_files())
      all.push_back(read_library_material(file.name, file.text));
    return all;
  }();
  return library;
}

const LibraryMaterial* find_library_material(std::string_view name) {
  for (const LibraryMaterial& entry : material_library())
    if (entry.name == name) return &entry;
  return nullptr;
}

std::string kind_name(MaterialKind kind) {
  return kind == MaterialKind::water ? "water" : "elastic";
}

}  // namespace kerf
