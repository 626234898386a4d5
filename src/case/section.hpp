// SPDX-License-Identifier: Apache-2.0
// One table of a case file, read by the schema. A value that is missing or wrong becomes a problem
// and a harmless number, so that reading goes on to the next one; the caller throws at the end.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// The library is compiled once, in libtomlplusplus.
#include <toml++/toml.h>

#include "case/case.hpp"
#include "case/problems.hpp"
#include "case/schema.hpp"

namespace kerf {

// What all tables of one file share.
struct Reading {
  Problems problems;
  std::filesystem::path folder;  // that of the case file, from which other files are named
  int dimension = 2;
};

class Section {
 public:
  // `section` names the rows of the schema; `path` is how complaints call the table.
  Section(Reading& reading, const toml::table& table, std::string section, std::string path);

  // States a condition under which keys apply, such as "rigid"; the dimension is one from the
  // start.
  void assume(const std::string& condition) { conditions_.insert(condition); }

  bool has(std::string_view name) const { return table_.contains(name); }
  std::string path(std::string_view name) const;
  Reading& reading() const { return reading_; }

  // Each reads the key `name`. When it is not written: the fallback, else the schema's default,
  // else a problem.
  double number(std::string_view name, std::optional<double> fallback = {});
  int integer(std::string_view name);
  bool flag(std::string_view name);
  std::string text(std::string_view name, std::optional<std::string> fallback = {});
  Point vector(std::string_view name, std::optional<Point> fallback = {});
  std::vector<double> quantities(std::string_view name, std::vector<double> fallback);
  std::vector<std::array<double, 2>> vertices(std::string_view name);
  // One formula per dimension in `variables`, checked.
  std::array<std::string, 3> expressions(std::string_view name,
                                         const std::vector<std::string>& variables);
  std::string expression(std::string_view name, const std::vector<std::string>& variables);
  Faces faces(std::string_view name);
  // A table inside this one, or null.
  const toml::table* table(std::string_view name);
  // The tables of a list, with the problem noted when the list or an entry is something else.
  std::vector<const toml::table*> tables(std::string_view name);

  // Notes a problem of the key `name`; what is allowed comes from the schema unless given.
  void refuse(std::string_view name, const std::string& what, const std::string& remedy,
              std::optional<std::string> allowed = {});
  // Notes keys that nobody knows and keys that have no meaning here. To be called when all
  // conditions are stated.
  void refuse_unknown();

 private:
  const Key& key(std::string_view name) const;
  const toml::node* node(const Key& key);
  // One quantity or number of a key; `where` says which entry of a list it is.
  double entry(const Key& key, const toml::node& node, const std::string& where);
  void wrong_type(const Key& key, const std::string& where);
  std::string checked_expression(const Key& key, const toml::node& node,
                                 const std::vector<std::string>& variables);

  Reading& reading_;
  const toml::table& table_;
  std::string section_;
  std::string path_;
  std::set<std::string> conditions_;
};

// A value of the file as one short line, for complaints.
std::string show(const toml::node& node);
// Line of a value of the file.
int line_of(const toml::node& node);
// Letters, digits, '-' and '_', at most 64.
bool is_name(std::string_view text);

}  // namespace kerf
