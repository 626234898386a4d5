// SPDX-License-Identifier: Apache-2.0
#include "app/table_conditions.hpp"

#include "input/material_library.hpp"
#include "input/schema.hpp"
#include "model/formulation.hpp"

namespace kerf {

TableConditions::TableConditions(const toml::table& root) : root_(root) {
  common_.insert(root_["dimension"].value_or(2) == 3 ? "3D" : "2D");
  const std::string formulation = word_in(root_, "formulation");
  common_.insert(formulation.empty() ? formulation_name(Formulation::standard) : formulation);
}

// Returns "elastic" where the case does not tell.
std::string TableConditions::kind_of_material(const std::string& name) const {
  std::string base = name;
  if (const toml::table* own = root_["materials"][name].as_table()) {
    if (const std::string kind = word_in(*own, "kind"); !kind.empty()) return kind;
    base = word_in(*own, "base");
  }
  const LibraryMaterial* entry = find_library_material(base);
  return kind_name(entry ? entry->kind : MaterialKind::elastic);
}

// Returns the conditions of a table that do not follow from the words of its keys.
TableConditions::Conditions TableConditions::first(std::string_view section,
                                                   const toml::table& table) const {
  Conditions conditions = common_;
  if (section == "body" && !table.contains("role"))
    conditions.insert(kind_of_material(word_in(table, "material")));
  if (section == "jet") {
    const bool has_length = common_.count("2D") != 0 || table.contains("length");
    conditions.insert("slot");
    if (!has_length) conditions.insert("round");
  }
  const LibraryMaterial* base =
      section == "materials" ? find_library_material(word_in(table, "base")) : nullptr;
  if (base) conditions.merge(base->conditions());
  return conditions;
}

// Adds the words of the keys of the table, the defaults included.
void TableConditions::add_words(std::string_view section, const toml::table& table,
                                Conditions& conditions) const {
  for (const Key& key : keys_of(section)) {
    if (key.kind != ValueKind::word || !key.applies_under(conditions)) continue;
    const std::string word = word_in(table, key.name);
    if (!word.empty())
      conditions.insert(word);
    else if (!key.required() && !key.computed())
      conditions.insert(default_text(key));
  }
}

TableConditions::Conditions TableConditions::of(std::string_view section,
                                                const toml::table& table) const {
  Conditions conditions = first(section, table);
  add_words(section, table, conditions);
  return conditions;
}

std::string word_in(const toml::table& table, std::string_view name) {
  return table[name].value_or(std::string());
}

}  // namespace kerf
