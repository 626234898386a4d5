// SPDX-License-Identifier: Apache-2.0
// CommandWords is what a command line consists of, as the parser knows it: the manual page and the
// completion of shells are made from it, so that they name every option that there is.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace kerf {

struct OptionWords {
  std::vector<std::string> names;    // "--out", "-h"; of an argument without dashes its one name
  std::string value;                 // what it takes, such as "INT in [1 - 4096]"; empty for a flag
  std::vector<std::string> choices;  // the values, where they are words
  std::string standard;              // its default; empty where there is none
  std::string description;
  bool required = false;
};

struct CommandWords {
  std::string name, description;
  std::vector<OptionWords> options, arguments;
};

// Returns the program itself, and then its commands in the order of the help.
std::vector<CommandWords> command_words(const CLI::App& program);

}  // namespace kerf
