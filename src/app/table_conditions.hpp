// SPDX-License-Identifier: Apache-2.0
// This header declares the conditions under which the keys of the tables of a case apply, as far as
// its text tells them, whether or not the case is valid.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace kerf {

class TableConditions {
 public:
  using Conditions = std::set<std::string>;

  // The case must outlive this.
  explicit TableConditions(const toml::table& root);

  // Returns those of all tables: the dimension and the formulation.
  const Conditions& common() const { return common_; }
  // Returns those of a table, the words that its keys hold included.
  Conditions of(std::string_view section, const toml::table& table) const;

 private:
  std::string kind_of_material(const std::string& name) const;
  Conditions first(std::string_view section, const toml::table& table) const;
  void add_words(std::string_view section, const toml::table& table, Conditions& conditions) const;

  const toml::table& root_;
  Conditions common_;
};

// Returns the text that a key holds; empty if it holds none.
std::string word_in(const toml::table& table, std::string_view name);

}  // namespace kerf
