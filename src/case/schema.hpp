// SPDX-License-Identifier: Apache-2.0
// Every key of a case file, once. Reading, refusing, docs/keys.md, the suggestions for misspelt
// keys and case.used.toml are driven by this table.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

enum class ValueKind {
  text,
  name,         // text of letters, digits, '-' and '_'
  word,         // one of `choices`
  integer,      // whole number
  number,       // pure number
  flag,         // true or false
  quantity,     // "5 m/s", in `unit`
  vector,       // one quantity per dimension, or one number where `unit` is empty
  quantities,   // ascending list of quantities
  vertices,     // list of [x, y] quantities
  expression,   // formula
  expressions,  // one formula per dimension
  faces,        // list of some of `choices`: sides of a box
  table,
  tables
};

struct Range {
  double minimum;
  double maximum;
  bool open_minimum = false;  // the minimum itself is refused
  bool open_maximum = false;
};

struct Key {
  std::string_view section;  // "" is the top level
  std::string_view name;
  ValueKind kind;
  std::string_view unit;  // SI
  // The default as one would write it; "" = the key must be given; in brackets, how it is found
  // when left out; "none" = infinity, which may also be written.
  std::string_view standard;
  Range range;
  std::string_view choices;  // words separated by blanks
  // Where the key has a meaning: "" everywhere, else alternatives separated by blanks, each a list
  // of conditions joined by '+', e.g. "disc+3D ring+3D".
  std::string_view applies;
  std::string_view sentence;

  bool required() const { return standard.empty(); }
  bool computed() const { return !standard.empty() && standard.front() == '('; }
  bool applies_under(const std::set<std::string>& conditions) const;
};

struct SectionText {
  std::string_view section;
  std::string_view heading;
  std::string_view sentence;
};

std::span<const Key> schema();
std::span<const SectionText> schema_sections();

// The key of that name that has a meaning under the conditions; else one that has none; else null.
const Key* find_key(std::string_view section, std::string_view name,
                    const std::set<std::string>& conditions);
std::vector<std::string> key_names(std::string_view section,
                                   const std::set<std::string>& conditions);

std::vector<std::string> split_words(std::string_view words, char separator = ' ');
// What the key may hold, in words: "a length greater than 0 m", "elastic, water or rigid".
std::string allowed_text(const Key& key);
bool in_range(const Key& key, double value);
// The number that holds when the key is left out; 0 where it must be given.
double standard_number(const Key& key);
// docs/keys.md.
std::string keys_page();

}  // namespace kerf
