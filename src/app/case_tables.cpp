// SPDX-License-Identifier: Apache-2.0
// This file implements form_tables(): the tables of a case with the keys that apply there.
#include <fmt/format.h>

#include <algorithm>

#include "app/case_form.hpp"
#include "app/new_table.hpp"
#include "app/table_conditions.hpp"
#include "input/entered_value.hpp"
#include "input/parse_toml.hpp"
#include "input/schema.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

class FormTables {
 public:
  explicit FormTables(const std::string& text)
      : places_(text), root_(parse_toml(text, "")), conditions_(root_) {}

  Json all();

 private:
  Json keys(std::string_view section, const std::string& path, const toml::table& table) const;
  void add(std::string_view section, const std::string& path, const std::string& heading,
           const toml::table* table);
  void add_section(std::string_view name);
  void add_several(std::string_view name);
  void add_inner(std::string_view section, const std::string& path, const std::string& heading,
                 const toml::table& table);

  TextPlaces places_;
  toml::table root_;
  TableConditions conditions_;
  Json tables_ = Json::array();
};

Json FormTables::keys(std::string_view section, const std::string& path,
                      const toml::table& table) const {
  const auto conditions = conditions_.of(section, table);
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
                     {"removable", is_repeatable(section)},
                     {"keys", keys(section, path, table ? *table : none)}});
}

// Adds the tables inside an entry of a list that have sections of their own: those that are
// written, and the grading that a body may have.
void FormTables::add_inner(std::string_view section, const std::string& path,
                           const std::string& heading, const toml::table& table) {
  const auto conditions = conditions_.of(section, table);
  for (const std::string name : {"shape", "grading"}) {
    const toml::table* inner = table[name].as_table();
    const Key* key = find_key(section, name, conditions);
    const bool is_offered = name == "grading" && key && key->applies_under(conditions);
    if (inner || is_offered)
      add(name, fmt::format("{}.{}", path, name), fmt::format("{} {}", heading, name), inner);
  }
}

// Adds the tables of a section that a case may hold several of, and the place for another one.
void FormTables::add_several(std::string_view name) {
  const toml::node* node = root_.get(name);
  const toml::array* list = node ? node->as_array() : nullptr;
  for (std::size_t n = 0; list && n < list->size(); ++n) {
    const toml::table* table = list->get(n)->as_table();
    if (!table) continue;
    const std::string path = fmt::format("{}[{}]", name, n + 1);
    const std::string own = word_in(*table, name == "load" ? "body" : "name");
    const std::string heading = fmt::format("[[{}]] {}", name, own);
    add(name, path, heading, table);
    add_inner(name, path, heading, *table);
  }
  if (const toml::table* named = node ? node->as_table() : nullptr)
    for (const auto& [own, value] : *named)
      if (const std::string path = fmt::format("{}.{}", name, own.str()); value.is_table())
        add(name, path, fmt::format("[{}]", path), value.as_table());
  if (!find_key("", name, conditions_.common())->applies_under(conditions_.common())) return;
  tables_.push_back({{"section", name},
                     {"path", name},
                     {"heading", word_of_table(name)},
                     {"written", false},
                     {"adds", true},
                     {"asks_name", !is_list(name)},
                     {"keys", Json::array()}});
}

void FormTables::add_section(std::string_view name) {
  if (name == "shape" || name == "grading") return;
  if (name.empty()) return add(name, "", "The case", &root_);
  if (is_repeatable(name)) return add_several(name);
  const toml::node* node = root_.get(name);
  add(name, std::string(name), fmt::format("[{}]", name), node ? node->as_table() : nullptr);
}

Json FormTables::all() {
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
