// SPDX-License-Identifier: Apache-2.0
// Section reads one table of a case file by the schema. It records a value that is missing or wrong
// as a problem and replaces it by a valid one, so that the next key can be read; the caller throws
// the problems at the end.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// The library is compiled once, in libtomlplusplus.
#include <toml++/toml.h>

#include "input/problems.hpp"
#include "input/schema.hpp"
#include "model/machine.hpp"

namespace kerf {

// The state that all tables of one file share.
struct Reading {
  Problems problems;
  std::filesystem::path folder;  // of the case file; paths of other files are relative to it
  int dimension = 2;
  std::string formulation{};  // its word; empty until it is read
};

class Section {
 public:
  // `section` names the rows of the schema; `path` is the table's name in messages. The initial
  // conditions are the dimension and the formulation.
  Section(Reading& reading, const toml::table& table, std::string section, std::string path);

  // States a condition under which keys apply, such as "rigid".
  void assume(std::string_view condition) { conditions_.emplace(condition); }
  void withdraw(std::string_view condition) { conditions_.erase(std::string(condition)); }
  const std::set<std::string>& conditions() const { return conditions_; }

  bool has(std::string_view name) const { return table_.contains(name); }
  std::string path(std::string_view name) const;
  Reading& reading() const { return reading_; }

  // Returns whether a key that is not written keeps its current value instead of the default.
  using KeepRule = std::function<bool(const Key&)>;
  // Reads each key that `structure` stores, in the order of the schema, if it applies under the
  // conditions and was not read before. A key that is not written gets its default; if that is
  // computed, it keeps its current value. The word of a key becomes a condition.
  template <class Structure>
  void read(Structure& structure, const KeepRule& keep = {}) {
    read_members(&structure_id<Structure>, &structure, keep, {});
  }
  // Does the same for the key `name` only. Returns whether it has no problem.
  template <class Structure>
  bool read_one(std::string_view name, Structure& structure) {
    const std::size_t before = reading_.problems.count();
    read_members(&structure_id<Structure>, &structure, {}, name);
    return reading_.problems.count() == before;
  }

  // Each of these functions reads the key `name`. If it is not written, the result is the fallback,
  // else the default of the schema; if there is none either, the key is recorded as a problem.
  double number(std::string_view name, std::optional<double> fallback = {});
  std::string text(std::string_view name, std::optional<std::string> fallback = {});
  Point vector(std::string_view name);
  // Returns the enumerator of a word, which becomes a condition.
  template <class Enumeration>
  Enumeration word(std::string_view name, std::optional<Enumeration> fallback = {}) {
    const auto position = fallback ? std::optional(static_cast<std::size_t>(*fallback))
                                   : std::optional<std::size_t>();
    return static_cast<Enumeration>(word_position(name, position));
  }
  // Returns a table inside this one, or null.
  const toml::table* table(std::string_view name);
  // Returns the tables of a list. Records a problem if the list or an entry is of another type.
  std::vector<const toml::table*> tables(std::string_view name);
  // Accepts that a required key is missing in this table, because another problem covers it.
  void excuse(std::string_view name) { done_.emplace(name); }

  // Records a problem of the key `name`; `allowed` is by default the text of the schema. Of a key
  // that could not be read this says nothing: what stands in its place is not of the file.
  void refuse(std::string_view name, const std::string& what, const std::string& remedy,
              std::optional<std::string> allowed = {});
  // Records unknown keys, and keys that do not apply here, as problems. It must be called after all
  // conditions are stated.
  void refuse_unknown();

 private:
  struct Assign;

  const Key& key(std::string_view name) const;
  const toml::node* node(const Key& key);
  void read_members(const void* id, void* structure, const KeepRule& keep, std::string_view only);
  // Reads one quantity or number of a key; `where` names the entry of a list.
  double entry(const Key& key, const toml::node& node, const std::string& where);
  double number(const Key& key);
  std::int64_t integer(const Key& key);
  bool flag(const Key& key);
  std::string text(const Key& key);
  std::size_t word_position(std::string_view name, std::optional<std::size_t> fallback);
  std::size_t word_position(const Key& key);
  Point vector(const Key& key);
  std::vector<double> quantities(const Key& key);
  std::vector<std::array<double, 2>> vertices(const Key& key);
  std::array<std::string, 3> expressions(const Key& key);
  std::string expression(const Key& key);
  Faces faces(const Key& key);
  // Records that a key could not be read.
  void fail(std::string_view name, const std::string& what, const std::string& remedy);
  void wrong_type(const Key& key, const std::string& where);
  void no_number(const Key& key, const toml::node& node, const std::string& where);
  std::string checked_expression(const Key& key, const toml::node& node);

  Reading& reading_;
  const toml::table& table_;
  std::string section_;
  std::string path_;
  std::set<std::string> conditions_;
  std::set<std::string, std::less<>> done_;        // keys that were read
  std::set<std::string, std::less<>> unreadable_;  // those that failed
};

// Returns a value of the file as one short line, for messages.
std::string show(const toml::node& node);
// Returns the line of a value in the file.
int line_of(const toml::node& node);
// Returns whether the text has only letters, digits, '-' and '_', at most 64.
bool is_name(std::string_view text);

}  // namespace kerf
