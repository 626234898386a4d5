// SPDX-License-Identifier: Apache-2.0
#include "input/material_library.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "input/schema.hpp"
#include "model/material_laws.hpp"

namespace kerf {

namespace {

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
  std::set<std::string> conditions{formulation_name(formulation)};
  keys_stored_in("materials", material, conditions);
  return conditions;
}

std::span<const KnownQuantity> known_quantities() {
  return all_known;
}

std::string LibraryValue::interval_text() const {
  if (!interval) return {};
  return fmt::format("{} {} to {}", name, interval->low_written, interval->high_written);
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
  material.criterion = criterion.value_or(BondCriterion::principal_strain);
  return material_conditions(material, Formulation::standard);
}

Material LibraryMaterial::material(Formulation formulation) const {
  Material result;
  result.name = name;
  result.kind = kind;
  if (formulation == Formulation::standard) {
    result.plasticity = plasticity;
    result.criterion = criterion.value_or(
        default_criterion(find("fracture_energy") && !find("failure_strain"), plasticity));
  }
  result.source = "Kerf's library: " + title;
  std::set<std::string> conditions{formulation_name(formulation)};
  for (const Key* key : keys_stored_in("materials", result, conditions)) {
    const ValueReference value = key->member.of(&result);
    double* const* number = std::get_if<double*>(&value);
    if (!number || key->computed()) continue;
    const LibraryValue* given = find(key->name);
    **number = given ? given->value : standard_number(*key);
  }
  if (formulation != Formulation::standard) result.fracture_energy = 0.0;
  result.uncalibrated = uncalibrated(result, formulation);
  return result;
}

std::string LibraryMaterial::uncalibrated(const Material& material, Formulation formulation) const {
  const auto numbers = numbers_in("materials", material, {formulation_name(formulation)});
  std::vector<std::string> intervals;
  for (const LibraryValue& value : values) {
    const auto is_used = [&](const NamedNumber& number) {
      return number.name == value.name && number.value == value.value;
    };
    if (value.interval && std::any_of(numbers.begin(), numbers.end(), is_used))
      intervals.push_back(value.interval_text());
  }
  return fmt::format("{}", fmt::join(intervals, ", "));
}

bool LibraryMaterial::has_intervals() const {
  return std::any_of(values.begin(), values.end(),
                     [](const LibraryValue& value) { return value.interval.has_value(); });
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
  return std::string(word_of(kind, material_kind_words));
}

}  // namespace kerf
