// SPDX-License-Identifier: Apache-2.0
// What commands of the shell print.
#pragma once

#include <cstdio>
#include <string>

namespace kerf::test {

// Returns what a command prints; ends with "(failed)" where the command fails.
inline std::string printed_by(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "(failed)";
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  return pclose(pipe) == 0 ? text : text + "(failed)";
}

inline bool is_installed(const std::string& program) {
  return printed_by("command -v " + program + " > /dev/null && printf yes") == "yes";
}

}  // namespace kerf::test
