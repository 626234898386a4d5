// SPDX-License-Identifier: Apache-2.0
// Functions of Section that read lists, expressions and tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/error.hpp"
#include "input/section.hpp"
#include "input/units.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"

namespace kerf {

namespace {

// Appends a value in the notation of TOML, until the line is longer than `enough`.
void append_value(std::string& line, const toml::node& node, std::size_t enough) {
  if (const auto text = node.value_exact<std::string>()) {
    line += '"' + text->substr(0, enough) + '"';
  } else if (const toml::array* list = node.as_array()) {
    line += "[";
    for (std::size_t i = 0; i < list->size() && line.size() <= enough; ++i) {
      line += i == 0 ? "" : ", ";
      append_value(line, (*list)[i], enough);
    }
    line += "]";
  } else if (const auto number = node.value_exact<double>()) {
    const std::string digits = shortest(*number);
    line += digits;
    // A whole number with a point is none of TOML.
    if (digits.find_first_of(".en") == std::string::npos) line += ".0";
  } else if (node.is_table()) {
    line += "{ ... }";
  } else {
    std::ostringstream stream;
    node.visit([&](const auto& value) { stream << value; });
    line += stream.str();
  }
}

}  // namespace

std::vector<double> Section::quantities(const Key& key) {
  const toml::node* value = node(key);
  std::vector<double> result;
  if (!value) return result;
  const toml::array* list = value->as_array();
  if (!list) return wrong_type(key, {}), result;
  for (std::size_t i = 0; i < list->size(); ++i) {
    result.push_back(entry(key, (*list)[i], fmt::format("entry {}: ", i + 1)));
    if (i == 0 || result[i] > result[i - 1]) continue;
    fail(key.name, fmt::format("entry {} is not greater than the one before", i + 1),
         "Put the entries in rising order, each once");
    return result;
  }
  return result;
}

std::vector<std::array<double, 2>> Section::vertices(const Key& key) {
  const toml::node* value = node(key);
  std::vector<std::array<double, 2>> result;
  if (!value) return result;
  const toml::array* list = value->as_array();
  if (!list) return wrong_type(key, {}), result;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::array* corner = (*list)[i].as_array();
    const std::string where = fmt::format("corner {}: ", i + 1);
    if (!corner || corner->size() != 2) return wrong_type(key, where), result;
    result.push_back({entry(key, (*corner)[0], where), entry(key, (*corner)[1], where)});
  }
  return result;
}

std::string Section::checked_expression(const Key& key, const toml::node& node) {
  const auto written = node.value_exact<std::string>();
  if (!written) return wrong_type(key, {}), std::string("0");
  try {
    const Expression checked(*written, {key.choices.begin(), key.choices.end()});
  } catch (const UserError& error) {
    fail(key.name, error.what(), "Correct the formula");
  }
  return *written;
}

std::array<std::string, 3> Section::expressions(const Key& key) {
  const toml::node* value = node(key);
  std::array<std::string, 3> result{"0", "0", "0"};
  if (!value) return result;
  const toml::array* list = value->as_array();
  if (!list || static_cast<int>(list->size()) != reading_.dimension)
    return wrong_type(key, {}), result;
  for (std::size_t a = 0; a < list->size(); ++a) result[a] = checked_expression(key, (*list)[a]);
  return result;
}

std::string Section::expression(const Key& key) {
  const toml::node* value = node(key);
  return value ? checked_expression(key, *value) : std::string("1");
}

Faces Section::faces(const Key& key) {
  const toml::node* value = node(key);
  Faces result;
  if (!value) return result;
  const toml::array* list = value->as_array();
  if (!list) return wrong_type(key, {}), result;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const auto word = (*list)[i].value_exact<std::string>();
    const auto found = std::find(key.choices.begin(), key.choices.end(), word.value_or(""));
    if (found == key.choices.end()) {
      fail(key.name, fmt::format("entry {} is not such a side", i + 1), "Correct the entry");
      return result;
    }
    const auto side = static_cast<std::size_t>(found - key.choices.begin());
    (side % 2 == 0 ? result.minimum : result.maximum)[side / 2] = true;
  }
  return result;
}

const toml::table* Section::table(std::string_view name) {
  const Key& wanted = key(name);
  const toml::node* value = node(wanted);
  if (value && !value->is_table()) wrong_type(wanted, {});
  return value ? value->as_table() : nullptr;
}

std::vector<const toml::table*> Section::tables(std::string_view name) {
  const Key& wanted = key(name);
  const toml::node* value = node(wanted);
  std::vector<const toml::table*> result;
  if (!value) return result;
  const toml::array* list = value->as_array();
  if (!list) {
    wrong_type(wanted, value->is_table() ? "one table stands where a list of them should: " : "");
    return result;
  }
  for (const toml::node& item : *list) {
    if (!item.is_table()) return wrong_type(wanted, {}), result;
    result.push_back(item.as_table());
  }
  return result;
}

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

std::string show(const toml::node& node) {
  constexpr std::size_t longest = 60;
  std::string line;
  append_value(line, node, 2 * longest);
  if (line.size() <= longest) return line;
  std::size_t cut = longest;
  // The line is not cut within a UTF-8 character.
  while (cut > 0 && (static_cast<unsigned char>(line[cut]) & 0xC0) == 0x80) --cut;
  return line.substr(0, cut) + " ...";
}

bool is_name(std::string_view text) {
  constexpr std::size_t longest = 64;
  if (text.empty() || text.size() > longest) return false;
  for (const char c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && !(c >= '0' && c <= '9') && c != '-' && c != '_') return false;
  }
  return true;
}

}  // namespace kerf
