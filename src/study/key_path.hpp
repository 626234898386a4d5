// SPDX-License-Identifier: Apache-2.0
// This header declares paths of keys, such as "machine.pressure" or "body.block.shape.maximum.1":
// the names of tables, the names or numbers (from 0) of list entries, and a key of the schema at
// the end.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "input/schema.hpp"

namespace kerf {

struct KeyPath {
  std::string text;                   // as written
  std::vector<std::string> segments;  // its parts
  std::string place;                  // the same for all paths to a key: entries by their numbers
  const Key* key = nullptr;           // of the schema
  std::string problem;                // why it leads to no key; empty = it does

  // Returns whether the value is one number, in `unit()`.
  bool is_number() const;
  std::string unit() const { return std::string(key->unit); }  // SI; "" = a pure number
};

// Follows the path through a case as written. Optional tables that are not written count as
// present.
KeyPath find_key_path(const std::string& path, const toml::table& case_table);

// Returns the value that the case writes at a path; null where it writes none.
toml::node* find_value(toml::table& case_table, const KeyPath& path);

// Sets the value of the key at a path. A material that the case takes from the library gets a table
// of its own, based on the library's.
void set_key(toml::table& case_table, const KeyPath& path, const toml::node& value);

// Sets a number given in SI units in the form that the key has: plain, or a text with its unit.
void set_number(toml::table& case_table, const KeyPath& path, double value);

}  // namespace kerf
