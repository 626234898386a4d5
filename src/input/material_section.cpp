// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <set>
#include <vector>

#include "fracture/bond_criterion.hpp"
#include "input/draft.hpp"
#include "input/material_fracture.hpp"
#include "input/material_library.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "model/case.hpp"
#include "model/law_keys.hpp"
#include "model/material_laws.hpp"

namespace kerf {

namespace {

// Returns the keys of a material that belong to no law.
std::vector<Key> plain_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"base", name, "", "(none)", any, {}, "", "Material of the library that gives the values missing here"},
      {"kind", word, "", "(that of the base)", any, material_kind_words, "", "Kind of the material; needed without a base", stored_in<&Material::kind>},
      {"density", quantity, "kg/m3", "", up_to(1e5), {}, "", "Density at rest", stored_in<&Material::density>},
      {"youngs_modulus", quantity, "Pa", "", up_to(1e13), {}, "elastic", "Young's modulus E", stored_in<&Material::youngs_modulus>},
      {"poisson_ratio", number, "", "", {-1.0, 0.5, true, true}, {}, "elastic", "Poisson's ratio", stored_in<&Material::poisson_ratio>},
      {"failure_strain", number, "", "0", from_zero_to(10.0), {}, "elastic", "Strain at which the material fractures: the equivalent strain of a particle, or in the standard formulation the value of the criterion at a bond; 0 = never", stored_in<&Material::failure_strain>},
      {"fracture_energy", quantity, "J/m2", "0 J/m2", from_zero_to(1e7), {}, "elastic", "Fracture energy per area of a crack; alone it makes the material brittle, with a strength that follows from the spacing; only in the standard formulation", stored_in<&Material::fracture_energy>},
      {"elasticity", word, "", "neo_hookean", any, elastic_law_words, "elastic+standard", "Law of elasticity; a material with plasticity has Hencky's", stored_in<&Material::elasticity>},
      {"plasticity", word, "", "(that of the base, or none)", any, plastic_law_words, "elastic+standard", "Law of plasticity: of metals (von_mises, johnson_cook), or of rock (drucker_prager)", stored_in<&Material::plasticity>},
      {"criterion", word, "", "(that of the base; of a fracture_energy without a failure_strain or plasticity brittle_band; otherwise principal_strain)", any, bond_criterion_words, "elastic+standard", "Fracture criterion at a bond: a strain, or the energy stored in tension, is compared with the failure_strain, the largest principal stress with the tensile_strength; crack_band: softening from the failure_strain on that dissipates the fracture_energy; brittle_band: the same with the fracture_energy alone, for brittle cracks in any direction; grady_kipp: damage by cracks that grow from flaws", stored_in<&Material::criterion>},
      {"friction", number, "", "0", from_zero_to(10.0), {}, "elastic+standard", "Coefficient of dry friction on other bodies; the smaller of two applies", stored_in<&Material::friction>},
      {"viscosity", quantity, "Pa s", "0 Pa s", from_zero_to(1e6), {}, "water", "Dynamic viscosity", stored_in<&Material::viscosity>},
      {"equation_of_state", word, "", "(tait; shock_hugoniot if something moves faster than 150 m/s and neither a sound speed nor an exponent is given)", any, equation_of_state_words, "water+standard", "Equation of state: weakly compressible water, or water with the shock speeds of real water", stored_in<&Material::equation_of_state>},
      {"sound_speed", quantity, "m/s", "(sound_speed_factor times the fastest speed; 1481 m/s with shock_hugoniot)", up_to(1e8), {}, "water", "Sound speed of the equation of state at rest", stored_in<&Material::sound_speed>},
      {"sound_speed_factor", number, "", "10", {1.0, 1000.0}, {}, "tait water+shinohara2004", "Sound speed over the fastest speed V of jets and bodies or, for falling water, V = sqrt(2 g H), H = height of the water; eq. (18)", stored_in<&MaterialDraft::sound_speed_factor>},
      {"artificial_linear", number, "", "0.01", from_zero_to(10.0), {}, "water", "A of the artificial viscosity, eq. (38)", stored_in<&Material::artificial_linear>},
      {"artificial_linear", number, "", "0.5", from_zero_to(10.0), {}, "elastic+standard", "A of the artificial viscosity, eq. (38)", stored_in<&Material::artificial_linear>},
      {"artificial_linear", number, "", "2.5", from_zero_to(10.0), {}, "elastic+shinohara2004", "A of the artificial viscosity, eq. (38)", stored_in<&Material::artificial_linear>},
      {"artificial_quadratic", number, "", "0", from_zero_to(10.0), {}, "water", "B of the artificial viscosity, eq. (38)", stored_in<&Material::artificial_quadratic>},
      {"artificial_quadratic", number, "", "0.5", from_zero_to(10.0), {}, "elastic+standard", "B of the artificial viscosity, eq. (38)", stored_in<&Material::artificial_quadratic>},
      {"artificial_quadratic", number, "", "2.5", from_zero_to(10.0), {}, "elastic+shinohara2004", "B of the artificial viscosity, eq. (38)", stored_in<&Material::artificial_quadratic>},
      {"artificial_softening", number, "", "0.1", up_to(1.0), {}, "", "C of the artificial viscosity, eq. (39)", stored_in<&Material::artificial_softening>},
      {"uncalibrated", text, "", "(those of the base that the case does not give)", any, {}, "elastic", "Values that are known within an interval only, with the intervals; a validity flag and `kerf check` ask to calibrate them (`kerf study` with `[calibrate]`)", stored_in<&Material::uncalibrated>},
      {"source", text, "", "(the case file)", any, {}, "", "Source of the values", stored_in<&Material::source>},
  };
  // clang-format on
}

}  // namespace

std::vector<Key> material_keys() {
  std::vector<Key> keys;
  for (const Key& key : plain_keys()) {
    keys.push_back(key);
    for (const Key& of_law : law_keys(key.name)) keys.push_back(of_law);
  }
  return keys;
}

namespace {

std::vector<std::string> library_names() {
  std::vector<std::string> names;
  for (const LibraryMaterial& entry : material_library()) names.emplace_back(entry.name);
  return names;
}

void refuse_unknown_material(Section& section, std::string_view key, const std::string& name,
                             const std::vector<std::string>& known) {
  const std::string guess = closest(name, known);
  section.refuse(key, "there is no such material",
                 guess.empty() ? fmt::format("Choose one of these or describe it in a table "
                                             "[materials.NAME]")
                               : fmt::format("Did you mean \"{}\"?", guess),
                 fmt::format("{}", fmt::join(known, ", ")));
}

const LibraryMaterial* read_base(Section& section) {
  if (!section.has("base")) return nullptr;
  const std::string name = section.text("base");
  const LibraryMaterial* base = find_library_material(name);
  if (!base && is_name(name)) refuse_unknown_material(section, "base", name, library_names());
  return base;
}

MaterialKind read_kind(Section& section, const LibraryMaterial* base) {
  if (!base && !section.has("kind") && !section.has("base"))
    section.refuse("kind", "the key is missing", "Add it, or name a base of the library");
  const MaterialKind fallback = base ? base->kind : MaterialKind::elastic;
  const auto kind = section.word<MaterialKind>("kind", fallback);
  if (base && kind != fallback)
    section.refuse("kind", fmt::format("the base is of the kind \"{}\"", kind_name(fallback)),
                   "Remove the key or choose another base",
                   fmt::format("\"{}\"", kind_name(fallback)));
  return kind;
}

// Refuses a case that gives both the sound speed and its factor.
void check_sound_speed(Section& section) {
  if (section.has("sound_speed") && section.has("sound_speed_factor"))
    section.refuse("sound_speed_factor", "the sound speed itself is given as well",
                   "Remove one of the two", "one of sound_speed and sound_speed_factor");
}

// The default equation of state of water follows from the fastest speed, after all sections are
// read.
bool equation_is_open(const Section& section, Formulation formulation, const Material& material) {
  if (material.kind != MaterialKind::water || formulation != Formulation::standard) return false;
  for (const char* key :
       {"equation_of_state", "sound_speed", "sound_speed_factor", "tait_exponent"})
    if (section.has(key)) return false;
  return true;
}

// A key that is not written keeps the value of the base if it applies to the laws of the base.
Section::KeepRule values_of(const Material& base, Formulation formulation) {
  return [inherited = material_conditions(base, formulation)](const Key& key) {
    return find_key("materials", key.name, inherited)->applies_under(inherited);
  };
}

// A material with another criterion than its base has no values of that of the base.
void forget_criterion(BondCriterion of_base, Material& material) {
  if (material.criterion == of_base) return;
  BondCriterionSet<double>::visit(*material.laws, of_base, [](auto& law) { law = {}; });
}

// What the case does not give is as uncertain as in the library.
std::string uncalibrated_values(const Section& section, const LibraryMaterial& base,
                                const Material& material, Formulation formulation) {
  LibraryMaterial left = base;
  std::erase_if(left.values, [&](const LibraryValue& value) { return section.has(value.name); });
  return left.uncalibrated(material, formulation);
}

MaterialDraft read_material(Section& section, Formulation formulation, const std::string& name) {
  const LibraryMaterial* base = read_base(section);
  MaterialDraft draft;
  Material& material = draft.material;
  material = base ? base->material(formulation) : Material{};
  const MaterialKind kind = read_kind(section, base);
  const bool inherits = base && base->kind == kind;
  if (!inherits) material.source = "the case file";
  const auto keep = inherits ? values_of(material, formulation) : Section::KeepRule();
  material.kind = kind;
  material.name = name;
  const BondCriterion of_base = material.criterion;
  section.read(material, keep);
  choose_criterion(section, base, formulation, material);
  if (inherits) forget_criterion(of_base, material);
  section.read(draft);
  draft.equation_is_open = equation_is_open(section, formulation, material);
  check_sound_speed(section);
  resolve_fracture(section, formulation, material);
  if (inherits && !section.has("uncalibrated"))
    material.uncalibrated = uncalibrated_values(section, *base, material, formulation);
  section.refuse_unknown();
  return draft;
}

}  // namespace

void read_materials(Draft& draft, Section& top) {
  const toml::table* list = top.table("materials");
  if (!list) return;
  for (const auto& [key, value] : *list) {
    const std::string name(key.str());
    const std::string path = "materials." + name;
    draft.reading.problems.mention(path, static_cast<int>(key.source().begin.line), show(value));
    if (!is_name(name)) {
      draft.reading.problems.add({path, "this is not a name",
                                  "at most 64 letters, digits, '-' and '_'",
                                  "Choose another name"});
    } else if (!value.is_table()) {
      draft.reading.problems.add({path, "a material is a table", "a table [materials.NAME]",
                                  fmt::format("Write [materials.{}] and its keys below", name)});
    } else {
      Section section(draft.reading, *value.as_table(), "materials", path);
      draft.materials[name] = read_material(section, draft.result.formulation, name);
    }
  }
}

const MaterialDraft* use_material(Draft& draft, Section& section, const std::string& name) {
  const auto found = draft.materials.find(name);
  if (found != draft.materials.end()) return &found->second;
  if (const LibraryMaterial* entry = find_library_material(name)) {
    constexpr double standard_factor = 10.0;  // c = 10 V, eq. (18)
    const bool open =
        entry->kind == MaterialKind::water && draft.result.formulation == Formulation::standard;
    return &(
        draft.materials[name] = {entry->material(draft.result.formulation), standard_factor, open});
  }
  std::vector<std::string> known = library_names();
  for (const auto& [other, material] : draft.materials)
    if (!find_library_material(other)) known.push_back(other);
  refuse_unknown_material(section, "material", name, known);
  return nullptr;
}

std::string material_text(const Case& description, int material) {
  return toml_string(description.materials[static_cast<std::size_t>(material)].name);
}

void write_material(TomlWriter& writer, const Material& material) {
  WrittenKeys left_out;
  if (material.uncalibrated.empty()) left_out["uncalibrated"] = "";
  writer.table(fmt::format("[materials.{}]", material.name), "materials", material, left_out);
}

}  // namespace kerf
