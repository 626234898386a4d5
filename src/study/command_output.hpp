// SPDX-License-Identifier: Apache-2.0
// Another program's words.
#pragma once

#include <string>
#include <vector>

namespace kerf {

struct CommandOutput {
  int exit_code = -1;  // -1 = there is no such program
  std::string output;  // standard output
  std::string errors;  // standard error
};

// Runs a program of the PATH to its end, without a shell.
CommandOutput output_of(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace kerf
