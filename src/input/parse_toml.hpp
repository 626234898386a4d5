// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace kerf {

// Returns the table of a TOML text. Throws a CaseError that names file, line and fault where the
// text is not valid.
toml::table parse_toml(std::string_view text, std::string_view file_name);

// Returns the line of a key, such as "body[1].spacing", in a valid TOML text; that of its table
// where the key is not written, and 1 without one.
int line_of_key(const std::string& text, const std::string& path);

// Returns whether a text is valid TOML of that content.
bool means(const std::string& text, const toml::table& content);

}  // namespace kerf
