// SPDX-License-Identifier: Apache-2.0
#include "input/parse_toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>

#include "input/problems.hpp"
#include "input/toml_path.hpp"

namespace kerf {
namespace {

// Returns how to write a line `key = word` whose word lacks its quotes; nothing for other lines.
std::string quoted_line(std::string_view text, int number) {
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int n = 0; n < number; ++n) std::getline(lines, line);
  static const std::regex form(
      R"(^\s*([A-Za-z0-9_.-]+)\s*=\s*([A-Za-z][A-Za-z0-9_ ./-]{0,60}?)\s*(#.*)?\r?$)");
  std::smatch match;
  if (line.size() > 200 || !std::regex_match(line, match, form)) return {};
  return fmt::format(" A text is in quotes: {} = \"{}\".", match.str(1), match.str(2));
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view file_name) {
  try {
    return toml::parse(text, file_name);
  } catch (const toml::parse_error& error) {
    const int line = static_cast<int>(error.source().begin.line);
    const std::string what = fmt::format("this is not valid TOML: {}", error.description());
    const std::string remedy = fmt::format("Correct the line.{}", quoted_line(text, line));
    throw CaseError(fmt::format("{}:{}: {}. {}", file_name, line, what, remedy),
                    {FoundProblem{{"", what, "", remedy}, line}});
  }
}

int line_of_key(const std::string& text, const std::string& path) {
  toml::table root = toml::parse(text);
  const PathSteps steps = steps_of(path);
  const toml::table* table = table_at(root, without_last(steps));
  if (table == nullptr) return 1;
  const toml::node* value = table->get(steps.back().name);
  const toml::node& node = value == nullptr ? *table : *value;
  return std::max(1, static_cast<int>(node.source().begin.line));
}

bool means(const std::string& text, const toml::table& content) {
  try {
    return toml::parse(text) == content;
  } catch (const toml::parse_error&) {
    return false;
  }
}

}  // namespace kerf
