// SPDX-License-Identifier: Apache-2.0
#include "input/entered_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "input/toml_writer.hpp"
#include "input/trimmed.hpp"

namespace kerf {

namespace {

bool is_list(const Key& key) {
  switch (key.kind) {
    case ValueKind::vector:
    case ValueKind::quantities:
    case ValueKind::expressions:
    case ValueKind::faces:
      return true;
    default:
      return false;
  }
}

bool is_bare(const Key& key) {
  const bool is_number = key.kind == ValueKind::integer || key.kind == ValueKind::number ||
                         (key.kind == ValueKind::vector && key.unit.empty());
  return is_number || key.kind == ValueKind::flag;
}

// Returns whether the text is a number, or true or false, of TOML.
bool is_bare_toml(std::string_view text) {
  if (text.find_first_of("\n#,") != std::string_view::npos) return false;
  try {
    const toml::table parsed = toml::parse(fmt::format("x = {}\n", text));
    const toml::node* value = parsed.get("x");
    return parsed.size() == 1 && value && (value->is_number() || value->is_boolean());
  } catch (const toml::parse_error&) {
    return false;
  }
}

std::string plain_literal(const Key& key, std::string_view entered) {
  return is_bare(key) && is_bare_toml(entered) ? std::string(entered) : toml_string(entered);
}

// Splits at the commas that are outside of brackets, which the calls of a formula have.
std::vector<std::string_view> entries_of(std::string_view list) {
  std::vector<std::string_view> entries;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= list.size(); ++at) {
    const char c = at < list.size() ? list[at] : ',';
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (at < list.size() && (c != ',' || depth > 0)) continue;
    entries.push_back(trimmed(list.substr(begin, at - begin)));
    begin = at + 1;
  }
  return entries;
}

bool is_plain(const toml::node& node) {
  return node.is_string() || node.is_number() || node.is_boolean();
}

std::string plain_value(const toml::node& node, const TextPlaces& places) {
  if (const auto* text = node.as_string()) return text->get();
  return places.slice(node.source());
}

}  // namespace

std::string literal_of(const Key& key, std::string_view entered) {
  const std::string_view text = trimmed(entered);
  if (text.empty()) return {};
  if (!is_list(key)) return plain_literal(key, text);
  std::vector<std::string> literals;
  for (const std::string_view entry : entries_of(text))
    literals.push_back(plain_literal(key, entry));
  return fmt::format("[{}]", fmt::join(literals, ", "));
}

bool fits_a_line(const Key& key) {
  return key.kind != ValueKind::vertices && key.kind != ValueKind::table &&
         key.kind != ValueKind::tables;
}

std::string entered_value(const toml::node& node, const TextPlaces& places) {
  if (is_plain(node)) return plain_value(node, places);
  const toml::array* list = node.as_array();
  if (!list || !std::all_of(list->begin(), list->end(), is_plain))
    return places.slice(node.source());
  std::vector<std::string> entries;
  for (const toml::node& entry : *list) entries.push_back(plain_value(entry, places));
  return fmt::format("{}", fmt::join(entries, ", "));
}

}  // namespace kerf
