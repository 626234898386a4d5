// SPDX-License-Identifier: Apache-2.0
// Texts in tables of comma-separated values.
#pragma once

#include <string>

namespace kerf {

// As it is, or quoted as RFC 4180 has it where it holds commas, quotes or ends of lines.
inline std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace kerf
