// SPDX-License-Identifier: Apache-2.0
// Adds whole tables to the text of a case file, and removes them. All other bytes of the text
// remain.
#pragma once

#include <string>
#include <string_view>

namespace kerf {

// Returns the text with another table behind the last one of its kind, or else at the end.
// `heading` is "[[body]]" or "[materials.gel]", `lines` the keys of the table as TOML. Throws a
// UserError where the text is not valid TOML or the table cannot be added to it.
std::string with_table(const std::string& text, std::string_view heading, const std::string& lines);

// Returns the text without the table of a path, such as "body[2]" or "materials.gel", with the
// comment above its heading: undoes with_table(). Throws a UserError where the text is not valid
// TOML, there is no such table, or it cannot be removed as it is written.
std::string without_table(const std::string& text, std::string_view path);

}  // namespace kerf
