// SPDX-License-Identifier: Apache-2.0
// The schema is the table of all keys of a case file, by section. Reading, refusing, docs/keys.md,
// the suggestions for misspelt keys and case.used.toml follow from its rows (core/case_key.hpp).
// The rows of a section are in the file that reads the values which no single member stores.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"

namespace kerf {

struct SchemaSection {
  std::string_view name;      // "" is the top level
  std::string_view heading;   // of its table in docs/keys.md
  std::string_view sentence;  // below that heading
  std::vector<Key> keys;
};

// Returns all sections, in the order of docs/keys.md.
std::span<const SchemaSection> schema();
// Returns the keys of a section; none if there is no such section.
std::span<const Key> keys_of(std::string_view section);

// Returns the key of that name that applies under the conditions; else any key of that name; else
// null.
const Key* find_key(std::string_view section, std::string_view name,
                    const std::set<std::string>& conditions);
std::vector<std::string> key_names(std::string_view section,
                                   const std::set<std::string>& conditions);

// Returns the keys of a section that the structure stores and that apply there. Adds the words that
// these keys hold to `conditions`.
template <class Structure>
std::vector<const Key*> keys_stored_in(std::string_view section, const Structure& structure,
                                       std::set<std::string>& conditions);
// Returns the value of a key in a structure that stores it; it must not be changed.
template <class Structure>
ValueReference value_in(const Structure& structure, const Key& key);
// A pure number or quantity of a structure, in SI units.
struct NamedNumber {
  std::string_view name;
  double value;
};
template <class Structure>
std::vector<NamedNumber> numbers_in(std::string_view section, const Structure& structure,
                                    std::set<std::string> conditions);

std::vector<std::string> split_words(std::string_view words, char separator = ' ');
// Returns the allowed values of a key in words: "a length greater than 0 m".
std::string allowed_text(const Key& key);
// Returns the default as docs/keys.md and case files write it: "0 m/s", "(off)", "none".
std::string default_text(const Key& key);
bool in_range(const Key& key, double value);
// Returns the default of a number; 0 for a required key.
double standard_number(const Key& key);
// Returns the text of docs/keys.md.
std::string keys_page();

// Implements the templates, without the type of the structure.
std::vector<const Key*> keys_stored_in(std::string_view section, const void* id, void* structure,
                                       std::set<std::string>& conditions);

template <class Structure>
std::vector<const Key*> keys_stored_in(std::string_view section, const Structure& structure,
                                       std::set<std::string>& conditions) {
  return keys_stored_in(section, &structure_id<Structure>, const_cast<Structure*>(&structure),
                        conditions);
}

template <class Structure>
ValueReference value_in(const Structure& structure, const Key& key) {
  return key.member.of(const_cast<Structure*>(&structure));
}

template <class Structure>
std::vector<NamedNumber> numbers_in(std::string_view section, const Structure& structure,
                                    std::set<std::string> conditions) {
  std::vector<NamedNumber> numbers;
  for (const Key* key : keys_stored_in(section, structure, conditions)) {
    const ValueReference value = value_in(structure, *key);
    if (const auto* number = std::get_if<double*>(&value)) numbers.push_back({key->name, **number});
  }
  return numbers;
}

}  // namespace kerf
