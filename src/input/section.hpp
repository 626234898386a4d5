// SPDX-License-Identifier: Apache-2.0
// This class reads one table of a case file by the schema. A value that is missing or wrong is
// noted as a problem and replaced by a harmless one, so that the next key can be read; the caller
// throws the problems at the end.
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

// What all tables of one file share.
struct Reading {
  Problems problems;
  std::filesystem::path folder;  // that of the case file, from which other files are named
  int dimension = 2;
  std::string formulation{};  // its word; empty until it is read
};

class Section {
 public:
  // `section` names the rows of the schema; `path` is the table's name in messages. The dimension
  // and the formulation are conditions from the start.
  Section(Reading& reading, const toml::table& table, std::string section, std::string path);

  // States a condition under which keys apply, such as "rigid".
  void assume(std::string_view condition) { conditions_.emplace(condition); }
  void withdraw(std::string_view condition) { conditions_.erase(std::string(condition)); }
  const std::set<std::string>& conditions() const { return conditions_; }

  bool has(std::string_view name) const { return table_.contains(name); }
  std::string path(std::string_view name) const;
  Reading& reading() const { return reading_; }

  // Whether the present value of a key that is not written shall stay, in place of the default.
  using KeepRule = std::function<bool(const Key&)>;
  // Reads each key that `structure` stores, in the order of the schema, if it has a meaning under
  // the conditions and was not read before. A key that is not written takes its default; where that
  // is computed, the present value stays. The word of a key becomes a condition.
  template <class Structure>
  void read(Structure& structure, const KeepRule& keep = {}) {
    read_members(&structure_id<Structure>, &structure, keep, {});
  }
  // The same for the one key `name`; whether no problem was noted.
  template <class Structure>
  bool read_one(std::string_view name, Structure& structure) {
    const std::size_t before = reading_.problems.count();
    read_members(&structure_id<Structure>, &structure, {}, name);
    return reading_.problems.count() == before;
  }

  // Each of these reads the one key `name`. When it is not written, the result is the fallback,
  // else the default of the schema, else a problem is noted.
  double number(std::string_view name, std::optional<double> fallback = {});
  std::string text(std::string_view name, std::optional<std::string> fallback = {});
  Point vector(std::string_view name);
  // The enumerator of a word, which becomes a condition.
  template <class Enumeration>
  Enumeration word(std::string_view name, std::optional<Enumeration> fallback = {}) {
    const auto position = fallback ? std::optional(static_cast<std::size_t>(*fallback))
                                   : std::optional<std::size_t>();
    return static_cast<Enumeration>(word_position(name, position));
  }
  // A table inside this one, or null.
  const toml::table* table(std::string_view name);
  // The tables of a list, with the problem noted when the list or an entry is something else.
  std::vector<const toml::table*> tables(std::string_view name);
  // A key that must be given but may be missing in this table, as another problem covers it.
  void excuse(std::string_view name) { done_.emplace(name); }

  // Notes a problem of the key `name`; what is allowed comes from the schema unless given.
  void refuse(std::string_view name, const std::string& what, const std::string& remedy,
              std::optional<std::string> allowed = {});
  // Notes keys that nobody knows and keys that have no meaning here. To be called when all
  // conditions are stated.
  void refuse_unknown();

 private:
  struct Assign;

  const Key& key(std::string_view name) const;
  const toml::node* node(const Key& key);
  void read_members(const void* id, void* structure, const KeepRule& keep, std::string_view only);
  // One quantity or number of a key; `where` says which entry of a list it is.
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
  void wrong_type(const Key& key, const std::string& where);
  std::string checked_expression(const Key& key, const toml::node& node);

  Reading& reading_;
  const toml::table& table_;
  std::string section_;
  std::string path_;
  std::set<std::string> conditions_;
  std::set<std::string, std::less<>> done_;  // keys that were read
};

// A value of the file as one short line, for messages.
std::string show(const toml::node& node);
// Line of a value of the file.
int line_of(const toml::node& node);
// Letters, digits, '-' and '_', at most 64.
bool is_name(std::string_view text);

}  // namespace kerf
