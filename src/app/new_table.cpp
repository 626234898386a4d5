// SPDX-License-Identifier: Apache-2.0
#include "app/new_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/start_values.hpp"
#include "app/table_conditions.hpp"
#include "core/error.hpp"
#include "input/edit_tables.hpp"
#include "input/parse_toml.hpp"
#include "input/schema.hpp"
#include "input/section.hpp"
#include "input/toml_writer.hpp"
#include "input/units.hpp"

namespace kerf {

namespace {

const SchemaSection& section_named(std::string_view name) {
  const auto sections = schema();
  const auto found =
      std::find_if(sections.begin(), sections.end(),
                   [&](const SchemaSection& section) { return section.name == name; });
  require(found != sections.end(), "there is no such section");
  return *found;
}

// Returns the names of the tables of a section.
std::vector<std::string> names_in(const toml::table& root, std::string_view section) {
  std::vector<std::string> names;
  const toml::node* node = root.get(section);
  const toml::array* list = node ? node->as_array() : nullptr;
  for (std::size_t n = 0; list && n < list->size(); ++n)
    if (const toml::table* table = list->get(n)->as_table())
      names.push_back(word_in(*table, "name"));
  if (const toml::table* named = node ? node->as_table() : nullptr)
    for (const auto& [name, value] : *named) names.emplace_back(name.str());
  return names;
}

std::string free_name(const toml::table& root, std::string_view section) {
  const auto taken = names_in(root, section);
  std::string name;
  std::size_t number = taken.size();
  do {
    name = fmt::format("{}-{}", word_of_table(section), ++number);
  } while (std::find(taken.begin(), taken.end(), name) != taken.end());
  return name;
}

std::string example_number(const Key& key) {
  const Range& range = key.range;
  if (in_range(key, 1.0)) return key.kind == ValueKind::integer ? "1" : "1.0";
  const bool is_bounded = std::isfinite(range.minimum) && std::isfinite(range.maximum);
  return shortest(is_bounded ? 0.5 * (range.minimum + range.maximum) : range.minimum + 1.0);
}

// Returns an example of what a key takes; empty for a table.
std::string example_of_key(const Key& key, std::size_t dimension) {
  const std::string one =
      key.unit.empty() ? example_number(key) : toml_string(example_of(std::string(key.unit)));
  switch (key.kind) {
    case ValueKind::word:
      return toml_string(key.choices.front());
    case ValueKind::flag:
      return "false";
    case ValueKind::integer:
    case ValueKind::number:
    case ValueKind::quantity:
      return one;
    case ValueKind::vector:
      return fmt::format("[{}]", fmt::join(std::vector<std::string>(dimension, one), ", "));
    case ValueKind::name:
    case ValueKind::text:
      return toml_string(key.name);
    case ValueKind::expression:
      return "\"1\"";
    default:
      return {};
  }
}

// Returns the keys of a table that must be given, or have a value to start from, in the order of
// the schema.
std::string lines_of(std::string_view section, const TableConditions& conditions,
                     const StartValues& values) {
  std::string written;
  for (const auto& [name, literal] : values) written += fmt::format("{} = {}\n", name, literal);
  auto applying = conditions.of(section, parse_toml(written, "the table"));
  if (applying.count("round") != 0) applying.erase("slot");  // the form offers the keys of both
  const std::size_t dimension = applying.count("3D") != 0 ? 3 : 2;
  const bool has_base = values.contains("base");  // which gives what is missing
  std::string lines;
  for (const Key& key : keys_of(section)) {
    if (find_key(section, key.name, applying) != &key) continue;
    const auto value = values.find(key.name);
    std::string literal = value == values.end() ? "" : value->second;
    if (literal.empty() && key.required() && key.applies_under(applying) && !has_base)
      literal = example_of_key(key, dimension);
    if (!literal.empty()) lines += fmt::format("{} = {}\n", key.name, literal);
  }
  return lines;
}

}  // namespace

bool is_list(std::string_view section) {
  return section_named(section).heading.starts_with("`[[");
}

bool is_repeatable(std::string_view section) {
  return is_list(section) || section_named(section).heading.ends_with(".NAME]`");
}

std::string word_of_table(std::string_view section) {
  const bool is_plural = !is_list(section) && section.ends_with('s');
  return std::string(section.substr(0, section.size() - (is_plural ? 1 : 0)));
}

NewTable with_new_table(const std::string& text, const std::string& file, std::string_view section,
                        const std::string& name) {
  const toml::table root = parse_toml(text, file);
  const std::string own = name.empty() ? free_name(root, section) : name;
  if (!is_name(own))
    throw UserError(
        fmt::format("\"{}\" is no name. Allowed: at most 64 letters, digits, '-' and '_'", own));
  StartValues values = start_values(section, root, text, file);
  if (find_key(section, "name", {})) values["name"] = toml_string(own);
  const std::string lines = lines_of(section, TableConditions(root), values);
  if (!is_list(section)) {
    const auto taken = names_in(root, section);
    if (std::find(taken.begin(), taken.end(), own) != taken.end())
      throw UserError(fmt::format("the name \"{}\" is used already. Choose another name", own));
    return {with_table(text, fmt::format("[{}.{}]", section, own), lines),
            fmt::format("{}.{}", section, own)};
  }
  return {with_table(text, fmt::format("[[{}]]", section), lines),
          fmt::format("{}[{}]", section, names_in(root, section).size() + 1)};
}

}  // namespace kerf
