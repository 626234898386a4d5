// SPDX-License-Identifier: Apache-2.0
#include "input/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "input/units.hpp"
#include "model/case.hpp"

namespace kerf {

Section::Section(Reading& reading, const toml::table& table, std::string section, std::string path)
    : reading_(reading), table_(table), section_(std::move(section)), path_(std::move(path)) {
  conditions_.insert(reading.dimension == 2 ? "2D" : "3D");
  if (!reading.formulation.empty()) conditions_.insert(reading.formulation);
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

// Returns the value of a key, or null if it is not written; records a missing required key.
const toml::node* Section::node(const Key& key) {
  done_.emplace(key.name);
  if (const toml::node* found = table_.get(key.name)) return found;
  if (key.required() && key.applies_under(conditions_))
    fail(key.name, "the key is missing", fmt::format("Add it: {}", key.sentence));
  return nullptr;
}

void Section::refuse(std::string_view name, const std::string& what, const std::string& remedy,
                     std::optional<std::string> allowed) {
  if (unreadable_.contains(name)) return;
  reading_.problems.add({path(name), what, allowed ? *allowed : allowed_text(key(name)), remedy});
}

void Section::fail(std::string_view name, const std::string& what, const std::string& remedy) {
  reading_.problems.add({path(name), what, allowed_text(key(name)), remedy});
  unreadable_.emplace(name);
}

// Refuses a value of a key that holds numbers.
void Section::no_number(const Key& key, const toml::node& node, const std::string& where) {
  const auto text = node.value_exact<std::string>();
  if (!text) return wrong_type(key, where);
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  const bool is_number =
      error == std::errc() && rest == text->data() + text->size() && std::isfinite(value);
  fail(key.name, where + "this is a text, not a number",
       is_number ? fmt::format("Write {} without quotes", *text)
                 : "Write a bare number, without quotes and unit");
}

void Section::wrong_type(const Key& key, const std::string& where) {
  fail(key.name, where + "this is not what the key holds",
       fmt::format("Write {}", allowed_text(key)));
}

double Section::entry(const Key& key, const toml::node& node, const std::string& where) {
  double value = 0.0;
  if (key.unit.empty()) {
    if (key.may_be_none() && node.value_exact<std::string>() == "none")
      return std::numeric_limits<double>::infinity();
    if (!node.is_number()) return no_number(key, node, where), value;
    value = *node.value<double>();
  } else {
    const std::string unit(key.unit);
    const auto written = node.value_exact<std::string>();
    const std::string remedy = fmt::format("Write a text such as \"{}\"", example_of(unit));
    if (!written && node.is_number())
      return fail(key.name, where + "a unit is missing", remedy), value;
    if (!written) return wrong_type(key, where), value;
    if (key.may_be_none() && *written == "none") return std::numeric_limits<double>::infinity();
    const Quantity quantity = read_quantity(*written, unit);
    if (!quantity.problem.empty()) return fail(key.name, where + quantity.problem, remedy), value;
    value = quantity.value;
  }
  if (!std::isfinite(value))
    fail(key.name, where + "the number is not finite", "Write a finite number");
  else if (!in_range(key, value))
    fail(key.name, where + "the value is out of range", "Choose a value in the range");
  return value;
}

double Section::number(std::string_view name, std::optional<double> fallback) {
  if (!fallback || has(name)) return number(key(name));
  done_.emplace(name);
  return *fallback;
}

double Section::number(const Key& key) {
  const toml::node* value = node(key);
  return value ? entry(key, *value, {}) : standard_number(key);
}

std::int64_t Section::integer(const Key& key) {
  const toml::node* value = node(key);
  if (!value) return static_cast<std::int64_t>(standard_number(key));
  const auto whole = value->value_exact<std::int64_t>();
  if (!whole) return no_number(key, *value, {}), 0;
  if (in_range(key, static_cast<double>(*whole))) return *whole;
  fail(key.name, "the value is out of range", "Choose a value in the range");
  return 0;
}

bool Section::flag(const Key& key) {
  const toml::node* value = node(key);
  if (!value) return key.standard.text == "true";
  if (!value->is_boolean()) wrong_type(key, {});
  return value->value_exact<bool>().value_or(false);
}

std::string Section::text(std::string_view name, std::optional<std::string> fallback) {
  if (!fallback || has(name)) return text(key(name));
  done_.emplace(name);
  return *fallback;
}

std::string Section::text(const Key& key) {
  const toml::node* value = node(key);
  if (!value) return std::string(key.standard.text);
  const auto written = value->value_exact<std::string>();
  if (!written) return wrong_type(key, {}), std::string();
  if (key.kind == ValueKind::name && !is_name(*written))
    fail(key.name, "this is not a name", "Choose another name");
  return *written;
}

std::size_t Section::word_position(std::string_view name, std::optional<std::size_t> fallback) {
  const Key& wanted = key(name);
  done_.emplace(name);
  const std::size_t position = fallback && !has(name) ? *fallback : word_position(wanted);
  assume(wanted.choices[position]);
  return position;
}

// Returns 0, the position of the first word, if no word or an unknown one is written.
std::size_t Section::word_position(const Key& key) {
  const std::string written = text(key);
  const auto found = std::find(key.choices.begin(), key.choices.end(), written);
  if (found != key.choices.end()) return static_cast<std::size_t>(found - key.choices.begin());
  if (const toml::node* value = table_.get(key.name); value && value->is_string()) {
    const std::string guess = closest(written, {key.choices.begin(), key.choices.end()});
    fail(key.name, "the word is unknown",
         guess.empty() ? "Choose one of these" : fmt::format("Did you mean \"{}\"?", guess));
  }
  return 0;
}

Point Section::vector(std::string_view name) {
  return vector(key(name));
}

Point Section::vector(const Key& key) {
  const toml::node* value = node(key);
  Point result{};
  const auto dimension = static_cast<std::size_t>(reading_.dimension);
  if (!value) {
    // The default applies to every component.
    std::fill_n(result.begin(), dimension, standard_number(key));
    return result;
  }
  const toml::array* list = value->as_array();
  if (!list || list->size() != dimension) {
    fail(key.name, fmt::format("a {0}D case needs a list of {0} entries here", reading_.dimension),
         "Write one entry for each dimension");
    return result;
  }
  for (std::size_t a = 0; a < list->size(); ++a)
    result[a] = entry(key, (*list)[a], fmt::format("entry {}: ", a + 1));
  return result;
}

// Reads the value of a key into the member that stores it.
struct Section::Assign {
  Section& section;
  const Key& key;

  void operator()(double* value) const { *value = section.number(key); }
  void operator()(int* value) const { *value = static_cast<int>(section.integer(key)); }
  void operator()(std::uint64_t* value) const {
    *value = static_cast<std::uint64_t>(section.integer(key));
  }
  void operator()(bool* value) const { *value = section.flag(key); }
  void operator()(std::string* value) const {
    *value = key.kind == ValueKind::expression ? section.expression(key) : section.text(key);
  }
  void operator()(Point* value) const { *value = section.vector(key); }
  void operator()(std::array<std::string, 3>* value) const { *value = section.expressions(key); }
  void operator()(std::vector<double>* value) const { *value = section.quantities(key); }
  void operator()(std::vector<std::array<double, 2>>* value) const {
    *value = section.vertices(key);
  }
  void operator()(Faces* value) const { *value = section.faces(key); }
  void operator()(const WordReference& word) const {
    word.set(word.value, section.word_position(key));
  }
};

void Section::read_members(const void* id, void* structure, const KeepRule& keep,
                           std::string_view only) {
  for (const Key& key : keys_of(section_)) {
    if (key.member.structure != id || !key.applies_under(conditions_)) continue;
    if (done_.count(key.name) != 0 || !(only.empty() || key.name == only)) continue;
    const ValueReference value = key.member.of(structure);
    if (has(key.name) || !(key.computed() || (keep && keep(key))))
      std::visit(Assign{*this, key}, value);
    if (const auto* word = std::get_if<WordReference>(&value))
      assume(key.choices[word->get(word->value)]);
  }
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
