// SPDX-License-Identifier: Apache-2.0
// The manual page of the program, made from its command line.
#pragma once

#include <string>
#include <vector>

#include "app/command_words.hpp"

namespace kerf {

// Returns kerf.1 in the language of man(7). `commands`: the program, then its commands.
std::string manual_page(const std::vector<CommandWords>& commands);

}  // namespace kerf
