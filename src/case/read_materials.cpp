// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <set>

#include "case/draft.hpp"
#include "case/material_library.hpp"

namespace kerf {

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
  const std::string fallback = base ? kind_name(base->kind) : "elastic";
  const std::string kind = section.text("kind", fallback);
  if (base && kind != fallback)
    section.refuse("kind", fmt::format("the base is of the kind \"{}\"", fallback),
                   "Remove the key or choose another base", fmt::format("\"{}\"", fallback));
  return kind == "water" ? MaterialKind::water : MaterialKind::elastic;
}

// Of the speed of sound and its factor at most one may be given.
void read_sound_speed(Section& section, MaterialDraft& draft) {
  if (section.has("sound_speed") && section.has("sound_speed_factor"))
    section.refuse("sound_speed_factor", "the speed of sound itself is given as well",
                   "Remove one of the two", "one of sound_speed and sound_speed_factor");
  draft.material.sound_speed = section.number("sound_speed", 0.0);
  draft.sound_speed_factor = section.number("sound_speed_factor");
}

// Softening begins at the strain and takes the energy.
void settle_crack_band(Section& section, Material& material) {
  if (material.criterion != BondCriterion::crack_band) return;
  if (material.failure_strain == 0.0)
    section.refuse("failure_strain", "the criterion \"crack_band\" softens from this strain on",
                   "Give the strain at which a tensile test breaks", "greater than 0");
  if (material.fracture_energy == 0.0)
    section.refuse("fracture_energy", "the criterion \"crack_band\" spends this energy",
                   "Give the energy of a crack per area", "greater than 0 J/m2");
  if (material.plasticity != PlasticLaw::none)
    section.refuse("criterion", "a material that flows does not soften as well",
                   "Choose another criterion, or plasticity = \"none\"",
                   "a criterion other than \"crack_band\"");
}

// In place of a strain, and where the criterion looks at bonds.
void settle_fracture(Section& section, Formulation formulation, Material& material) {
  if (material.criterion == BondCriterion::crack_band) return;
  if (!section.has("fracture_energy") || material.fracture_energy == 0.0) return;
  if (formulation != Formulation::standard)
    section.refuse("fracture_energy", "this formulation breaks particles at a strain",
                   "Give a failure_strain, or choose formulation = \"standard\"");
  if (section.has("failure_strain") && material.failure_strain > 0.0)
    section.refuse("fracture_energy", "a failure_strain is given as well", "Remove one of the two",
                   "one of failure_strain and fracture_energy");
  material.failure_strain = 0.0;
}

// A strength leaves nothing to a strain or an energy.
void settle_strength(Section& section, Material& material) {
  if (material.criterion != BondCriterion::principal_stress) return;
  for (const char* key : {"failure_strain", "fracture_energy"})
    if (section.has(key))
      section.refuse(key, "the criterion looks at the stress", "Remove the key, or the criterion",
                     "nothing beside the criterion \"principal_stress\"");
  material.failure_strain = material.fracture_energy = 0.0;
}

// Flaws are those of brittle rock, and leave nothing to a strain or an energy.
void settle_flaws(Section& section, Material& material) {
  if (material.criterion != BondCriterion::grady_kipp) return;
  for (const char* key : {"failure_strain", "fracture_energy"})
    if (section.has(key))
      section.refuse(key, "the criterion looks at flaws", "Remove the key, or the criterion",
                     "nothing beside the criterion \"grady_kipp\"");
  if (material.plasticity != PlasticLaw::none)
    section.refuse("criterion", "the material flows",
                   "Choose another criterion, or plasticity = \"none\"",
                   "\"grady_kipp\" where plasticity is \"none\"");
  material.failure_strain = material.fracture_energy = 0.0;
}

// That of water. Where it may follow from the fastest speed it is settled when all is read.
void read_equation_of_state(Section& section, Formulation formulation, MaterialDraft& draft) {
  if (formulation == Formulation::standard) {
    const std::string word = section.text("equation_of_state", "tait");
    draft.material.equation_of_state = law_of<EquationOfState>(word, equation_of_state_words);
    draft.equation_is_open = true;
    for (const char* key :
         {"equation_of_state", "sound_speed", "sound_speed_factor", "tait_exponent"})
      if (section.has(key)) draft.equation_is_open = false;
  }
  section.assume(std::string(word_of(draft.material.equation_of_state, equation_of_state_words)));
}

// The laws of a solid.
void read_laws(Section& section, Formulation formulation, Material& material) {
  const std::string fallback(word_of(material.plasticity, plastic_law_words));
  if (material.kind != MaterialKind::elastic) return;
  if (formulation == Formulation::standard) {
    material.elasticity = law_of<ElasticLaw>(section.text("elasticity"), elastic_law_words);
    material.plasticity =
        law_of<PlasticLaw>(section.text("plasticity", fallback), plastic_law_words);
    material.criterion = law_of<BondCriterion>(section.text("criterion"), bond_criterion_words);
  }
  for (const std::string& condition : material_conditions(material, formulation))
    section.assume(condition);
}

// The value of a base where there is one that has the key under the same laws.
void read_numbers(Section& section, Formulation formulation, const Material* base,
                  Material& material) {
  const auto inherited = base ? material_conditions(*base, formulation) : std::set<std::string>{};
  for (const MaterialField& field : material_fields(material_conditions(material, formulation))) {
    const bool has = base && find_key("materials", field.key, inherited)->applies_under(inherited);
    material.*field.member =
        has ? section.number(field.key, base->*field.member) : section.number(field.key);
  }
}

MaterialDraft read_material(Section& section, Formulation formulation, const std::string& name) {
  const LibraryMaterial* entry = read_base(section);
  MaterialDraft draft;
  draft.material = entry ? entry->material(formulation) : Material{};
  draft.material.kind = read_kind(section, entry);
  draft.material.name = name;
  section.assume(kind_name(draft.material.kind));
  section.assume(formulation_name(formulation));
  const bool based = entry && entry->kind == draft.material.kind;
  const Material base = draft.material;
  if (draft.material.kind == MaterialKind::water)
    read_equation_of_state(section, formulation, draft);
  read_laws(section, formulation, draft.material);
  read_numbers(section, formulation, based ? &base : nullptr, draft.material);
  if (draft.material.kind == MaterialKind::water) read_sound_speed(section, draft);
  settle_fracture(section, formulation, draft.material);
  settle_strength(section, draft.material);
  settle_crack_band(section, draft.material);
  settle_flaws(section, draft.material);
  draft.material.source =
      section.text("source", based ? draft.material.source : std::string("the case file"));
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

}  // namespace kerf
