// SPDX-License-Identifier: Apache-2.0
#include "case/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/units.hpp"
#include "core/error.hpp"

namespace kerf {

namespace {

std::string with_unit(double value, const Key& key) {
  return key.unit.empty() ? shortest(value) : write_quantity(value, std::string(key.unit));
}

std::string range_text(const Key& key) {
  const Range& range = key.range;
  const bool below = std::isfinite(range.minimum), above = std::isfinite(range.maximum);
  if (!below && !above) return {};
  const std::string low = with_unit(range.minimum, key), high = with_unit(range.maximum, key);
  if (!above) return fmt::format(" {} {}", range.open_minimum ? "greater than" : "at least", low);
  if (!range.open_minimum && !range.open_maximum) return fmt::format(" from {} to {}", low, high);
  return fmt::format(" {} {} and {} {}", range.open_minimum ? "greater than" : "at least", low,
                     range.open_maximum ? "less than" : "at most", high);
}

std::string listed(const std::vector<std::string>& words) {
  if (words.size() == 1) return fmt::format("\"{}\"", words.front());
  const std::vector<std::string> head(words.begin(), words.end() - 1);
  return fmt::format("\"{}\" or \"{}\"", fmt::join(head, "\", \""), words.back());
}

std::string quantity_text(const Key& key) {
  const std::string unit(key.unit);
  const std::string none = key.standard == "none" ? ", or \"none\"" : "";
  return fmt::format("{} with its unit, such as \"{}\",{}{}", dimension_of(unit), example_of(unit),
                     range_text(key).empty() ? " of any size" : range_text(key), none);
}

}  // namespace

bool Key::applies_under(const std::set<std::string>& conditions) const {
  if (applies.empty()) return true;
  for (const auto& alternative : split_words(applies)) {
    const auto needed = split_words(alternative, '+');
    if (std::all_of(needed.begin(), needed.end(),
                    [&](const std::string& word) { return conditions.count(word) != 0; }))
      return true;
  }
  return false;
}

const Key* find_key(std::string_view section, std::string_view name,
                    const std::set<std::string>& conditions) {
  const Key* without_meaning = nullptr;
  for (const Key& key : schema()) {
    if (key.section != section || key.name != name) continue;
    if (key.applies_under(conditions)) return &key;
    without_meaning = &key;
  }
  return without_meaning;
}

std::vector<std::string> key_names(std::string_view section,
                                   const std::set<std::string>& conditions) {
  std::vector<std::string> names;
  for (const Key& key : schema())
    if (key.section == section && key.applies_under(conditions)) names.emplace_back(key.name);
  return names;
}

std::vector<std::string> split_words(std::string_view words, char separator) {
  std::vector<std::string> result;
  while (!words.empty()) {
    const auto end = std::min(words.find(separator), words.size());
    if (end > 0) result.emplace_back(words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return result;
}

std::string allowed_text(const Key& key) {
  switch (key.kind) {
    case ValueKind::text:
      return "a text";
    case ValueKind::name:
      return "a name of at most 64 letters, digits, '-' and '_'";
    case ValueKind::word:
      return listed(split_words(key.choices));
    case ValueKind::integer:
      return "a whole number" + range_text(key);
    case ValueKind::number:
      return "a number without unit" + range_text(key) +
             (key.standard == "none" ? ", or \"none\"" : "");
    case ValueKind::flag:
      return "true or false";
    case ValueKind::quantity:
      return quantity_text(key);
    case ValueKind::vector:
      return key.unit.empty() ? "a list of one number for each dimension"
                              : "a list for each dimension of " + quantity_text(key);
    case ValueKind::quantities:
      return "a rising list of " + quantity_text(key);
    case ValueKind::vertices:
      return "a list of corners [x, y], each " + quantity_text(key);
    case ValueKind::expression:
      return "a formula, as a text";
    case ValueKind::expressions:
      return "a list of one formula, as a text, for each dimension";
    case ValueKind::faces:
      return "a list of sides: " + listed(split_words(key.choices));
    case ValueKind::table:
      return "a table";
    case ValueKind::tables:
      return "a list of tables";
  }
  return {};
}

bool in_range(const Key& key, double value) {
  const Range& range = key.range;
  if (!(value >= range.minimum && value <= range.maximum)) return false;
  if (range.open_minimum && value == range.minimum) return false;
  return !(range.open_maximum && value == range.maximum);
}

double standard_number(const Key& key) {
  require(!key.computed(), "a default that is computed has no fallback");
  if (key.required()) return 0.0;
  if (key.standard == "none") return std::numeric_limits<double>::infinity();
  if (key.unit.empty()) return std::stod(std::string(key.standard));
  return read_quantity(key.standard, std::string(key.unit)).value;
}

std::string keys_page() {
  std::string page =
      "# Keys of a case file\n\n"
      "Made by `kerf check --keys` from `src/case/schema_table.cpp`; not written by hand.\n\n"
      "A case is a [TOML](https://toml.io) file. Quantities are texts with a unit (\"300 MPa\",\n"
      "\"0.3 mm\", \"60 deg\"); any unit of "
      "[UDUNITS](https://www.unidata.ucar.edu/software/udunits/)\n"
      "of the right dimension will do. A default in brackets says how the value is found.\n";
  for (const SectionText& section : schema_sections()) {
    page += fmt::format(
        "\n## {}\n\n{}\n\n| key | holds | default | where | meaning |\n"
        "| --- | --- | --- | --- | --- |\n",
        section.heading, section.sentence);
    for (const Key& key : schema()) {
      if (key.section != section.section) continue;
      std::string where(key.applies);
      std::replace(where.begin(), where.end(), '+', '-');
      page += fmt::format("| `{}` | {} | {} | {} | {}. |\n", key.name, allowed_text(key),
                          key.required() ? "must be given" : key.standard,
                          where.empty() ? "everywhere" : where, key.sentence);
    }
  }
  return page;
}

}  // namespace kerf
