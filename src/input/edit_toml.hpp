// SPDX-License-Identifier: Apache-2.0
// Changes of single values in the text of a case file. All other bytes of the text, such as
// comments, remain.
#pragma once

#include <string>
#include <string_view>

namespace kerf {

// Returns the text with another value of a key. `path` is that of messages, such as
// "body[1].grading.levels"; `literal` is the value as TOML. A key or table that is not there is
// added; an empty literal removes the key, and its table where that becomes empty. Throws a
// UserError where the text is not valid TOML or this change cannot be made in it.
std::string with_value(const std::string& text, std::string_view path, const std::string& literal);

}  // namespace kerf
