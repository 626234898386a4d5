// SPDX-License-Identifier: Apache-2.0
// This header declares the values that suit a case for a new table of it.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace kerf {

// Literals of TOML by the names of keys.
using StartValues = std::map<std::string, std::string, std::less<>>;

// Returns values for a new table of a section, other than its name. `root` is the case as written;
// where it is valid, its bodies and jets decide on places and sizes.
StartValues start_values(std::string_view section, const toml::table& root, const std::string& text,
                         const std::string& file);

}  // namespace kerf
