// SPDX-License-Identifier: Apache-2.0
#include "input/key_text.hpp"

#include <algorithm>
#include <regex>

namespace kerf {

std::string key_label(const Key& key) {
  std::string label(key.name);
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

std::string key_help(const Key& key) {
  return plain_text(key.sentence) + ".";
}

std::string plain_text(std::string_view markdown) {
  static const std::regex lead(R"( *See \[[^\]]*\]\([^)]*\)\.)"), link(R"(\[([^\]]*)\]\([^)]*\))"),
      mark("`");
  std::string text(markdown);
  for (const auto& [pattern, by] : {std::pair{&lead, ""}, {&link, "$1"}, {&mark, ""}})
    text = std::regex_replace(text, *pattern, by);
  return text;
}

}  // namespace kerf
