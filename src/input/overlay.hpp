// SPDX-License-Identifier: Apache-2.0
// A case with some of its keys changed.
#pragma once

#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace kerf {

// The case as TOML text with `changes` put over it: tables are merged key by key; lists of tables
// (body, jet, probe) entry by entry, matched by their "name"; everything else, such as the parts of
// a shape, is replaced.
std::string overlay(std::string_view case_text, const toml::table& changes);

// The table of a list that has this name; null when none has.
toml::table* entry_named(toml::array& list, const std::string& name);

}  // namespace kerf
