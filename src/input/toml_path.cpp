// SPDX-License-Identifier: Apache-2.0
#include "input/toml_path.hpp"

#include <charconv>

#include "input/schema.hpp"

namespace kerf {

PathSteps steps_of(std::string_view path) {
  PathSteps steps;
  for (const std::string& word : split_words(path, '.')) {
    const auto bracket = word.find('[');
    PathStep step{word.substr(0, bracket)};
    if (bracket != std::string::npos)
      std::from_chars(word.data() + bracket + 1, word.data() + word.size(), step.entry);
    steps.push_back(std::move(step));
  }
  return steps;
}

PathSteps without_last(const PathSteps& steps) {
  return {steps.begin(), steps.end() - 1};
}

toml::table* table_at(toml::table& root, const PathSteps& steps) {
  toml::table* table = &root;
  for (const PathStep& step : steps) {
    toml::node* node = table->get(step.name);
    toml::array* list = node ? node->as_array() : nullptr;
    if (step.entry > 0) node = list ? list->get(step.entry - 1) : nullptr;
    table = node ? node->as_table() : nullptr;
    if (!table) return nullptr;
  }
  return table;
}

}  // namespace kerf
