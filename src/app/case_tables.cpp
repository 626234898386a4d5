// SPDX-License-Identifier: Apache-2.0
// This file implements form_tables(): the tables of a case with the keys that apply there.
#include <fmt/format.h>

#include <set>

#include "app/case_form.hpp"
#include "input/entered_value.hpp"
#include "input/material_library.hpp"
#include "input/parse_toml.hpp"
#include "input/schema.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;
using Conditions = std::set<std::string>;

std::string word_in(const toml::table& table, std::string_view name) {
  return table[name].value_or(std::string());
}

class FormTables {
 public:
  explicit FormTables(const std::string& text) : places_(text), root_(parse_toml(text, "")) {}

  Json all();

 private:
  std::string kind_of_material(const std::string& name) const;
  Conditions first_conditions(std::string_view section, const toml::table& table) const;
  void add_words(std::string_view section, const toml::table& table, Conditions& conditions) const;
  Json keys(std::string_view section, const std::string& path, const toml::table& table) const;
  void add(std::string_view section, const std::string& path, const std::string& heading,
           const toml::table* table);
  void add_section(std::string_view name);
  void add_inner(const std::string& path, const std::string& heading, const toml::table& table);

  TextPlaces places_;
  toml::table root_;
  Conditions common_;  // the dimension and the formulation
  Json tables_ = Json::array();
};

// Returns "elastic" where the case does not tell.
std::string FormTables::kind_of_material(const std::string& name) const {
  std::string base = name;
  if (const toml::table* own = root_["materials"][name].as_table()) {
    if (const std::string kind = word_in(*own, "kind"); !kind.empty()) return kind;
    base = word_in(*own, "base");
  }
  const LibraryMaterial* entry = find_library_material(base);
  return kind_name(entry ? entry->kind : MaterialKind::elastic);
}

// Returns the conditions of a table that do not follow from the words of its keys.
Conditions FormTables::first_conditions(std::string_view section, const toml::table& table) const {
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
void FormTables::add_words(std::string_view section, const toml::table& table,
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

Json FormTables::keys(std::string_view section, const std::string& path,
                      const toml::table& table) const {
  Conditions conditions = first_conditions(section, table);
  add_words(section, table, conditions);
  Json list = Json::array();
  const auto rows = keys_of(section);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const Key& key = rows[row];
    const toml::node* node = table.get(key.name);
    const bool is_chosen = find_key(section, key.name, conditions) == &key;
    if (!fits_a_line(key) || !is_chosen || !(node || key.applies_under(conditions))) continue;
    Json entry = {
        {"row", row},
        {"path", path.empty() ? std::string(key.name) : path + "." + std::string(key.name)},
        {"value", node ? entered_value(*node, places_) : ""}};
    list.push_back(std::move(entry));
  }
  return list;
}

void FormTables::add(std::string_view section, const std::string& path, const std::string& heading,
                     const toml::table* table) {
  static const toml::table none;
  tables_.push_back({{"section", section},
                     {"path", path},
                     {"heading", heading},
                     {"written", table != nullptr},
                     {"keys", keys(section, path, table ? *table : none)}});
}

// Adds the tables inside an entry of a list that have sections of their own.
void FormTables::add_inner(const std::string& path, const std::string& heading,
                           const toml::table& table) {
  for (const char* name : {"shape", "grading"})
    if (const toml::table* inner = table[name].as_table())
      add(name, fmt::format("{}.{}", path, name), fmt::format("{} {}", heading, name), inner);
}

void FormTables::add_section(std::string_view name) {
  if (name == "shape" || name == "grading") return;
  if (name.empty()) return add(name, "", "The case", &root_);
  const toml::node* node = root_.get(name);
  if (name == "materials") {
    if (!node || !node->is_table()) return;
    for (const auto& [own, value] : *node->as_table())
      if (const std::string path = fmt::format("materials.{}", own.str()); value.is_table())
        add(name, path, fmt::format("[{}]", path), value.as_table());
    return;
  }
  const bool is_list = name == "body" || name == "load" || name == "jet" || name == "probe";
  if (!is_list)
    return add(name, std::string(name), fmt::format("[{}]", name),
               node ? node->as_table() : nullptr);
  const toml::array* list = node ? node->as_array() : nullptr;
  for (std::size_t n = 0; list && n < list->size(); ++n) {
    const toml::table* table = list->get(n)->as_table();
    if (!table) continue;
    const std::string path = fmt::format("{}[{}]", name, n + 1);
    const std::string heading = fmt::format("[[{}]] {}", name, word_in(*table, "name"));
    add(name, path, heading, table);
    add_inner(path, heading, *table);
  }
}

Json FormTables::all() {
  common_.insert(root_["dimension"].value_or(2) == 3 ? "3D" : "2D");
  const std::string formulation = word_in(root_, "formulation");
  common_.insert(formulation.empty() ? formulation_name(Formulation::standard) : formulation);
  // What an operator sets comes first.
  constexpr std::string_view first[] = {"machine", "workpiece", ""};
  for (const std::string_view name : first) add_section(name);
  for (const SchemaSection& section : schema())
    if (std::find(std::begin(first), std::end(first), section.name) == std::end(first))
      add_section(section.name);
  return std::move(tables_);
}

}  // namespace

Json form_tables(const std::string& text) {
  return FormTables(text).all();
}

}  // namespace kerf
