// SPDX-License-Identifier: Apache-2.0
// Reads a file of materials/ as a material of the library; docs/materials.md has the format.
#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "input/material_library.hpp"
#include "input/schema.hpp"
#include "input/units.hpp"

namespace kerf {

namespace {

class LibraryFile {
 public:
  LibraryFile(std::string_view name, std::string_view text) : name_(name) {
    try {
      table_ = toml::parse(text);
    } catch (const toml::parse_error& error) {
      fail(fmt::format("line {}: {}", error.source().begin.line, error.description()));
    }
  }

  LibraryMaterial read() const {
    allow(table_, {"title", "kind", "plasticity", "criterion", "values", "known"});
    LibraryMaterial result;
    result.name = name_;
    result.title = text(table_, "title");
    const std::string kind = text(table_, "kind");
    if (kind != "water" && kind != "elastic") fail(fmt::format("unknown kind \"{}\"", kind));
    result.kind = kind == "water" ? MaterialKind::water : MaterialKind::elastic;
    if (table_.contains("plasticity"))
      result.plasticity = law<PlasticLaw>("plasticity", plastic_law_words);
    if (table_.contains("criterion"))
      result.criterion = law<BondCriterion>("criterion", bond_criterion_words);
    for (const toml::table* entry : entries("values"))
      add(result.values, case_value(*entry, result.conditions()));
    for (const toml::table* entry : entries("known")) add(result.known, known_value(*entry));
    refuse_missing(result);
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::logic_error(fmt::format("materials/{}.toml: {}", name_, what));
  }

  void allow(const toml::table& table, std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, node] : table)
      if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
        fail(fmt::format("unknown key \"{}\"", key.str()));
  }

  std::string text(const toml::table& table, std::string_view key) const {
    const auto written = table[key].value_exact<std::string>();
    if (!written || written->empty()) fail(fmt::format("{} must be a text", key));
    return *written;
  }

  std::vector<const toml::table*> entries(std::string_view list) const {
    std::vector<const toml::table*> result;
    const toml::node* node = table_.get(list);
    if (!node) return result;
    if (!node->is_array_of_tables()) fail(fmt::format("{} must be a list of tables", list));
    for (const toml::node& entry : *node->as_array()) result.push_back(entry.as_table());
    return result;
  }

  void add(std::vector<LibraryValue>& list, LibraryValue value) const {
    for (const LibraryValue& other : list)
      if (other.name == value.name) fail(fmt::format("{} is there twice", value.name));
    list.push_back(std::move(value));
  }

  template <class Law, class Words>
  Law law(std::string_view key, const Words& words) const {
    const std::string word = text(table_, key);
    const Law law = law_of<Law>(word, words);
    if (word_of(law, words) != word) fail(fmt::format("unknown {} \"{}\"", key, word));
    return law;
  }

  LibraryValue case_value(const toml::table& entry, const std::set<std::string>& conditions) const {
    allow(entry, {"key", "value", "source", "note", "interval"});
    const std::string name = text(entry, "key");
    const Key* key = find_key("materials", name, conditions);
    const bool number = key && (key->kind == ValueKind::quantity || key->kind == ValueKind::number);
    if (!number || !key->applies_under(conditions))
      fail(fmt::format("\"{}\" is no number of a material of this kind and law", name));
    LibraryValue result = measured(entry, name, key->unit);
    if (!in_range(*key, result.value))
      fail(fmt::format("{} = {} is out of range", name, result.written));
    if (entry.contains("interval")) result.interval = interval(entry, result, key->unit);
    return result;
  }

  ValueInterval interval(const toml::table& entry, const LibraryValue& of,
                         std::string_view unit) const {
    const toml::table* table = entry["interval"].as_table();
    if (!table) fail(fmt::format("the interval of {} must be a table", of.name));
    allow(*table, {"low", "high", "sources"});
    ValueInterval result;
    result.sources = text(*table, "sources");
    const auto end = [&](std::string_view key, double& value, std::string& written) {
      const LibraryValue read = number(*table, key, of.name, unit);
      value = read.value;
      written = read.written;
    };
    end("low", result.low, result.low_written);
    end("high", result.high, result.high_written);
    if (!(result.low < result.high && result.low <= of.value && of.value <= result.high))
      fail(fmt::format("{} = {} is not between {} and {}", of.name, of.written, result.low_written,
                       result.high_written));
    return result;
  }

  LibraryValue known_value(const toml::table& entry) const {
    allow(entry, {"name", "value", "source", "note"});
    const std::string name = text(entry, "name");
    for (const KnownQuantity& quantity : known_quantities())
      if (quantity.name == name) return measured(entry, name, quantity.unit);
    fail(fmt::format("\"{}\" is none of the known quantities", name));
  }

  LibraryValue measured(const toml::table& entry, const std::string& name,
                        std::string_view unit) const {
    LibraryValue result = number(entry, "value", name, unit);
    result.source = text(entry, "source");
    if (entry.contains("note")) result.note = text(entry, "note");
    return result;
  }

  // Reads the number of a key, and how it is written.
  LibraryValue number(const toml::table& table, std::string_view key, const std::string& name,
                      std::string_view unit) const {
    LibraryValue result{name, 0.0, {}, {}, {}};
    if (unit.empty()) {
      const toml::node* node = table.get(key);
      if (!node || !node->is_number()) fail(fmt::format("{} must be a number", name));
      result.value = *node->value<double>();
      result.written = shortest(result.value);
      return result;
    }
    result.written = text(table, key);
    const Quantity quantity = read_quantity(result.written, std::string(unit));
    if (!quantity.problem.empty()) fail(fmt::format("{}: {}", name, quantity.problem));
    result.value = quantity.value;
    return result;
  }

  void refuse_missing(const LibraryMaterial& material) const {
    const auto conditions = material.conditions();
    for (const Key& key : keys_of("materials"))
      if (key.required() && key.applies_under(conditions) && !material.find(key.name))
        fail(fmt::format("{} is missing", key.name));
  }

  std::string name_;
  toml::table table_;
};

}  // namespace

LibraryMaterial read_library_material(std::string_view name, std::string_view text) {
  return LibraryFile(name, text).read();
}

}  // namespace kerf
