// SPDX-License-Identifier: Apache-2.0
// This header declares how forms and study pages name and explain keys. The words are those of the
// schema.
#pragma once

#include <string>
#include <string_view>

#include "core/case_key.hpp"

namespace kerf {

// Returns the name of a key in words: "traverse speed".
std::string key_label(const Key& key);

// Returns the sentence of a key as it is shown in a page.
std::string key_help(const Key& key);

// Returns a sentence of the reference without its marks of Markdown, and without sentences that
// only lead to another page.
std::string plain_text(std::string_view markdown);

}  // namespace kerf
