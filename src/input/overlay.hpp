// SPDX-License-Identifier: Apache-2.0
// Changes of keys of a case.
#pragma once

#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace kerf {

// Returns the case as TOML text with `changes` applied: tables are merged key by key; lists of
// tables (body, jet, probe) entry by entry, matched by their "name"; all other values, such as the
// parts of a shape, are replaced.
std::string overlay(std::string_view case_text, const toml::table& changes);

// Returns the table of a list that has this name, or null.
toml::table* entry_named(toml::array& list, const std::string& name);

}  // namespace kerf
