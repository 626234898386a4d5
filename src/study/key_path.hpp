// SPDX-License-Identifier: Apache-2.0
// A key of a case by its path, "machine.pressure" or "body.block.shape.maximum.1": names of tables,
// of entries of lists (or their numbers, the first is 0), and at the end of a key of the schema.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "case/schema.hpp"

namespace kerf {

struct KeyPath {
  std::string text;                   // as written
  std::vector<std::string> segments;  // its parts
  const Key* key = nullptr;           // of the schema
  std::string problem;                // why it leads to no key; empty when it does

  // Whether the value is one number, in `unit()`.
  bool is_number() const;
  std::string unit() const { return std::string(key->unit); }  // SI; "" = a pure number
};

// Follows the path through a case as written; a table that is not written, but may be, counts.
KeyPath find_key_path(const std::string& path, const toml::table& case_table);

// Puts a value at a path that leads to a key. A material that the case takes from the library gets
// a table of its own, based on the library's.
void set_key(toml::table& case_table, const KeyPath& path, const toml::node& value);

// A number of SI units as the key wants it: plain, or a text with its unit.
void set_number(toml::table& case_table, const KeyPath& path, double value);

}  // namespace kerf
