// SPDX-License-Identifier: Apache-2.0
// This function writes texts in tables of comma-separated values.
#pragma once

#include <string>

namespace kerf {

// Returns the text, quoted by RFC 4180 where it contains commas, quotes or line ends.
inline std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace kerf
