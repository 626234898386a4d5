// SPDX-License-Identifier: Apache-2.0
#include "input/overlay.hpp"

#include <sstream>

namespace kerf {

namespace {

void merge(toml::table& base, const toml::table& changes);

// Returns whether the entries of a list have names; the parts of a shape, for example, have none.
bool has_named_tables(const toml::array& list) {
  return !list.empty() && list[0].is_table() && list[0].as_table()->contains("name");
}

void merge_lists(toml::array& base, const toml::array& changes) {
  for (const toml::node& node : changes) {
    const toml::table& change = *node.as_table();
    toml::table* entry = entry_named(base, change["name"].value_or(std::string()));
    if (entry)
      merge(*entry, change);
    else
      base.push_back(change);
  }
}

void merge(toml::table& base, const toml::table& changes) {
  for (const auto& [key, change] : changes) {
    toml::node* old = base.get(key);
    if (old && old->is_table() && change.is_table())
      merge(*old->as_table(), *change.as_table());
    else if (old && old->is_array() && change.is_array() && has_named_tables(*change.as_array()))
      merge_lists(*old->as_array(), *change.as_array());
    else
      change.visit([&, &name = key](const auto& value) { base.insert_or_assign(name, value); });
  }
}

}  // namespace

toml::table* entry_named(toml::array& list, const std::string& name) {
  for (toml::node& node : list) {
    toml::table* entry = node.as_table();
    if (entry && (*entry)["name"].value_or(std::string()) == name) return entry;
  }
  return nullptr;
}

std::string overlay(std::string_view case_text, const toml::table& changes) {
  toml::table result = toml::parse(case_text);
  merge(result, changes);
  std::ostringstream text;
  text << result;
  return text.str();
}

}  // namespace kerf
