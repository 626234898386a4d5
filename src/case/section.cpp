// SPDX-License-Identifier: Apache-2.0
#include "case/section.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "case/units.hpp"
#include "core/error.hpp"

namespace kerf {

Section::Section(Reading& reading, const toml::table& table, std::string section, std::string path)
    : reading_(reading), table_(table), section_(std::move(section)), path_(std::move(path)) {
  conditions_.insert(reading.dimension == 2 ? "2D" : "3D");
  if (!path_.empty()) reading_.problems.mention(path_, line_of(table_), {});
  for (const auto& [name, value] : table_)
    reading_.problems.mention(this->path(name.str()), static_cast<int>(name.source().begin.line),
                              show(value));
}

std::string Section::path(std::string_view name) const {
  return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

const Key& Section::key(std::string_view name) const {
  const Key* found = find_key(section_, name, conditions_);
  require(found != nullptr, "a key is read that the schema does not hold");
  return *found;
}

// The value of a key, or null when it is not written; a missing key that must be there is noted.
const toml::node* Section::node(const Key& key) {
  if (const toml::node* found = table_.get(key.name)) return found;
  if (key.required() && key.applies_under(conditions_))
    refuse(key.name, "the key is missing", fmt::format("Add it: {}", key.sentence));
  return nullptr;
}

void Section::refuse(std::string_view name, const std::string& what, const std::string& remedy,
                     std::optional<std::string> allowed) {
  reading_.problems.add({path(name), what, allowed ? *allowed : allowed_text(key(name)), remedy});
}

void Section::wrong_type(const Key& key, const std::string& where) {
  refuse(key.name, where + "this is not what the key holds",
         fmt::format("Write {}", allowed_text(key)));
}

double Section::entry(const Key& key, const toml::node& node, const std::string& where) {
  double value = 0.0;
  if (key.unit.empty()) {
    if (key.standard == "none" && node.value_exact<std::string>() == "none")
      return std::numeric_limits<double>::infinity();
    if (!node.is_number()) return wrong_type(key, where), value;
    value = *node.value<double>();
  } else {
    const std::string unit(key.unit);
    const auto written = node.value_exact<std::string>();
    const std::string remedy = fmt::format("Write a text such as \"{}\"", example_of(unit));
    if (!written && node.is_number())
      return refuse(key.name, where + "a unit is missing", remedy), value;
    if (!written) return wrong_type(key, where), value;
    if (key.standard == "none" && *written == "none")
      return std::numeric_limits<double>::infinity();
    const Quantity quantity = read_quantity(*written, unit);
    if (!quantity.problem.empty()) return refuse(key.name, where + quantity.problem, remedy), value;
    value = quantity.value;
  }
  if (!std::isfinite(value))
    refuse(key.name, where + "the number is not finite", "Write a finite number");
  else if (!in_range(key, value))
    refuse(key.name, where + "the value is out of range", "Choose a value in the range");
  return value;
}

double Section::number(std::string_view name, std::optional<double> fallback) {
  const Key& wanted = key(name);
  if (fallback && !has(name)) return *fallback;
  const toml::node* value = node(wanted);
  return value ? entry(wanted, *value, {}) : standard_number(wanted);
}

int Section::integer(std::string_view name) {
  const Key& wanted = key(name);
  const toml::node* value = node(wanted);
  if (!value) return static_cast<int>(standard_number(wanted));
  const auto whole = value->value_exact<std::int64_t>();
  if (!whole) return wrong_type(wanted, {}), 0;
  if (!in_range(wanted, static_cast<double>(*whole))) {
    refuse(name, "the value is out of range", "Choose a value in the range");
    return 0;
  }
  return static_cast<int>(*whole);
}

bool Section::flag(std::string_view name) {
  const Key& wanted = key(name);
  const toml::node* value = node(wanted);
  if (!value) return wanted.standard == "true";
  if (!value->is_boolean()) wrong_type(wanted, {});
  return value->value_exact<bool>().value_or(false);
}

std::string Section::text(std::string_view name, std::optional<std::string> fallback) {
  const Key& wanted = key(name);
  if (fallback && !has(name)) return *fallback;
  const toml::node* value = node(wanted);
  if (!value) return std::string(wanted.standard);
  const auto written = value->value_exact<std::string>();
  if (!written) return wrong_type(wanted, {}), std::string();
  const std::vector<std::string> words = split_words(wanted.choices);
  bool known = wanted.kind != ValueKind::word;
  for (const auto& word : words) known = known || word == *written;
  const std::string guess = closest(*written, words);
  if (!known)
    refuse(name, "the word is unknown",
           guess.empty() ? "Choose one of these" : fmt::format("Did you mean \"{}\"?", guess));
  if (wanted.kind == ValueKind::name && !is_name(*written))
    refuse(name, "this is not a name", "Choose another name");
  return *written;
}

Point Section::vector(std::string_view name, std::optional<Point> fallback) {
  const Key& wanted = key(name);
  const toml::node* value = node(wanted);
  Point result{};
  if (!value) {
    if (fallback) return *fallback;
    // The default stands for every component.
    for (int a = 0; a < reading_.dimension; ++a)
      result[static_cast<std::size_t>(a)] = standard_number(wanted);
    return result;
  }
  const toml::array* list = value->as_array();
  if (!list || static_cast<int>(list->size()) != reading_.dimension) {
    refuse(name,
           fmt::format("a {}D case needs a list of {} entries here", reading_.dimension,
                       reading_.dimension),
           "Write one entry for each dimension");
    return result;
  }
  for (std::size_t a = 0; a < list->size(); ++a)
    result[a] = entry(wanted, (*list)[a], fmt::format("entry {}: ", a + 1));
  return result;
}

void Section::refuse_unknown() {
  for (const auto& [written, value] : table_) {
    const std::string name(written.str());
    const Key* found = find_key(section_, name, conditions_);
    const std::vector<std::string> known = key_names(section_, conditions_);
    if (found && found->applies_under(conditions_)) continue;
    if (found) {
      refuse(
          name, "the key has no meaning here", fmt::format("Remove it. {}", found->sentence),
          fmt::format("only where this holds: {}", fmt::join(split_words(found->applies), " or ")));
      continue;
    }
    const std::string guess = closest(name, known);
    refuse(name, "the key is unknown",
           guess.empty() ? "Remove it" : fmt::format("Did you mean \"{}\"?", guess),
           fmt::format("{}", fmt::join(known, ", ")));
  }
}

}  // namespace kerf
