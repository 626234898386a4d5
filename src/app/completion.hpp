// SPDX-License-Identifier: Apache-2.0
// Scripts with which shells complete the command line of the program.
#pragma once

#include <string>
#include <vector>

#include "app/command_words.hpp"

namespace kerf {

// Each returns the script for a shell. `commands`: the program, then its commands.
std::string bash_completion(const std::vector<CommandWords>& commands);
std::string zsh_completion(const std::vector<CommandWords>& commands);
std::string fish_completion(const std::vector<CommandWords>& commands);

}  // namespace kerf
