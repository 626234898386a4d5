// SPDX-License-Identifier: Apache-2.0
#include "input/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "input/sections.hpp"
#include "input/units.hpp"

namespace kerf {

namespace {

std::vector<SchemaSection> all_sections() {
  return {
      {"", "Top level", "The keys before the first table.", top_keys()},
      {"time", "`[time]`", "Needed in every case without a `[machine]`.", time_keys()},
      {"domain", "`[domain]`",
       "Particles that leave the domain are removed and counted in the balance. The default is the "
       "box around all bodies and nozzles, extended on every side by half its longest edge.",
       domain_keys()},
      {"materials", "`[materials.NAME]`",
       "One table for each material that the library (`kerf materials`) lacks, or that differs "
       "from "
       "it.",
       material_keys()},
      {"body", "`[[body]]`", "One table for each body.", body_keys()},
      {"grading", "`grading = { ... }` of a body",
       "Off unless the table is there. See [graded resolution](theory/graded_resolution.md).",
       grading_keys()},
      {"shape", "`shape = { ... }` of a body",
       "Shapes nest: the `parts` of a union or difference are shapes.", shape_keys()},
      {"load", "`[[load]]`",
       "One table for each load on an elastic body, in addition to `gravity`. See "
       "[loads](theory/loads.md).",
       load_keys()},
      {"machine", "`[machine]`",
       "The settings of a machine, instead of a `[[jet]]`: the jet and its numerics follow from "
       "it. "
       "See [machine](theory/machine.md).",
       machine_keys()},
      {"workpiece", "`[workpiece]`",
       "A slab under a `[machine]`, in place of a `[[body]]`: its upper face is at y = 0, its "
       "middle "
       "at the origin. Kerf chooses the part that is simulated, its resolution, the domain and "
       "symmetry planes; each key sets one of them. See [real cuts](theory/exposure.md).",
       workpiece_keys()},
      {"jet", "`[[jet]]`",
       "A jet leaves its nozzle at `standoff` from `position` and flies towards it.", jet_keys()},
      {"back_flow_removal", "`[back_flow_removal]`",
       "Off unless the table is there. Used for Fig. 7 of Shinohara et al. (2004); it takes mass "
       "away.",
       back_flow_removal_keys()},
      {"probe", "`[[probe]]`", "One table for each probe.", probe_keys()},
      {"artificial_stress", "`[artificial_stress]`",
       "Off unless the table is there. After Gray, Monaghan & Swift (2001).",
       artificial_stress_keys()},
      {"numerics", "`[numerics]`", "Of the standard formulation. Everything has a default.",
       numerics_keys()},
      {"output", "`[output]`", "Everything has a default.", output_keys()},
  };
}

std::string with_unit(double value, const Key& key, Bound bound) {
  return key.unit.empty() ? shortest(value) : show_quantity(value, std::string(key.unit), bound);
}

std::string range_text(const Key& key) {
  const Range& range = key.range;
  const bool below = std::isfinite(range.minimum), above = std::isfinite(range.maximum);
  if (!below && !above) return {};
  const std::string low = with_unit(range.minimum, key, Bound::least),
                    high = with_unit(range.maximum, key, Bound::most);
  if (!above) return fmt::format(" {} {}", range.open_minimum ? "greater than" : "at least", low);
  if (!range.open_minimum && !range.open_maximum) return fmt::format(" from {} to {}", low, high);
  return fmt::format(" {} {} and {} {}", range.open_minimum ? "greater than" : "at least", low,
                     range.open_maximum ? "less than" : "at most", high);
}

std::string listed(std::span<const std::string_view> words) {
  if (words.size() == 1) return fmt::format("\"{}\"", words.front());
  const auto head = words.first(words.size() - 1);
  return fmt::format("\"{}\" or \"{}\"", fmt::join(head, "\", \""), words.back());
}

std::string quantity_text(const Key& key) {
  const std::string unit(key.unit);
  const std::string none = key.may_be_none() ? ", or \"none\"" : "";
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

std::span<const SchemaSection> schema() {
  static const std::vector<SchemaSection> sections = all_sections();
  return sections;
}

std::span<const Key> keys_of(std::string_view section) {
  for (const SchemaSection& candidate : schema())
    if (candidate.name == section) return candidate.keys;
  return {};
}

const Key* find_key(std::string_view section, std::string_view name,
                    const std::set<std::string>& conditions) {
  const Key* without_meaning = nullptr;
  for (const Key& key : keys_of(section)) {
    if (key.name != name) continue;
    if (key.applies_under(conditions)) return &key;
    without_meaning = &key;
  }
  return without_meaning;
}

std::vector<std::string> key_names(std::string_view section,
                                   const std::set<std::string>& conditions) {
  std::vector<std::string> names;
  for (const Key& key : keys_of(section))
    if (key.applies_under(conditions)) names.emplace_back(key.name);
  return names;
}

std::vector<const Key*> keys_stored_in(std::string_view section, const void* id, void* structure,
                                       std::set<std::string>& conditions) {
  std::vector<const Key*> keys;
  for (const Key& key : keys_of(section)) {
    if (key.member.structure != id || !key.applies_under(conditions)) continue;
    keys.push_back(&key);
    const ValueReference value = key.member.of(structure);
    if (const auto* word = std::get_if<WordReference>(&value))
      conditions.emplace(key.choices[word->get(word->value)]);
  }
  return keys;
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
      return listed(key.choices);
    case ValueKind::integer:
      return "a whole number" + range_text(key);
    case ValueKind::number:
      return "a number without unit" + range_text(key) + (key.may_be_none() ? ", or \"none\"" : "");
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
      return "a list of sides: " + listed(key.choices);
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

std::string default_text(const Key& key) {
  return key.standard.is_text() ? std::string(key.standard.text)
                                : with_unit(key.standard.number, key, Bound::none);
}

double standard_number(const Key& key) {
  require(!key.computed(), "a default that is computed has no fallback");
  if (!key.standard.is_text()) return key.standard.number;
  if (key.required()) return 0.0;
  if (key.may_be_none()) return std::numeric_limits<double>::infinity();
  if (key.unit.empty()) return std::stod(std::string(key.standard.text));
  return read_quantity(key.standard.text, std::string(key.unit)).value;
}

std::string keys_page() {
  std::string page =
      "# Keys of a case file\n\n"
      "Made by `kerf check --keys` from the tables of keys in `src/input`; not written by hand.\n\n"
      "A case is a [TOML](https://toml.io) file. Quantities are texts with a unit (\"300 MPa\",\n"
      "\"0.3 mm\", \"60 deg\"); any unit of "
      "[UDUNITS](https://www.unidata.ucar.edu/software/udunits/)\n"
      "of the right dimension is allowed. A default in brackets states how the value is "
      "computed.\n";
  for (const SchemaSection& section : schema()) {
    page += fmt::format(
        "\n## {}\n\n{}\n\n| key | holds | default | where | meaning |\n"
        "| --- | --- | --- | --- | --- |\n",
        section.heading, section.sentence);
    for (const Key& key : section.keys) {
      std::string where(key.applies);
      std::replace(where.begin(), where.end(), '+', '-');
      page += fmt::format("| `{}` | {} | {} | {} | {}. |\n", key.name, allowed_text(key),
                          key.required() ? "must be given" : default_text(key),
                          where.empty() ? "everywhere" : where, key.sentence);
    }
  }
  return page;
}

}  // namespace kerf
