// SPDX-License-Identifier: Apache-2.0
#include "app/command_words.hpp"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>

#include "app/embedded.hpp"
#include "input/material_library.hpp"

namespace kerf {
namespace {

// Sets value and choices from the type that the help shows: "TEXT:{cpu,gpu}", "INT:INT in [1 - 9]".
void set_value(const std::string& type, OptionWords& words) {
  const auto colon = type.find(':');
  words.value = colon == std::string::npos ? type : type.substr(colon + 1);
  const auto open = words.value.find('{'), close = words.value.find('}');
  if (open == std::string::npos || close == std::string::npos) return;
  const std::string list = words.value.substr(open + 1, close - open - 1);
  boost::split(words.choices, list, boost::is_any_of(","));
  words.value = type.substr(0, colon);
}

OptionWords option_words(const CLI::Option& option) {
  OptionWords words;
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  if (words.names.empty()) words.names.push_back(option.get_name());
  if (option.get_items_expected_max() > 0) set_value(option.get_type_name(), words);
  words.standard = option.get_default_str();
  words.description = option.get_description();
  words.required = option.get_required();
  return words;
}

CommandWords words_of(const CLI::App& command) {
  CommandWords words{command.get_name(), command.get_description(), {}, {}};
  for (const CLI::Option* option : command.get_options())
    (option->get_positional() ? words.arguments : words.options).push_back(option_words(*option));
  return words;
}

// The names that the argument of a command may have.
std::vector<std::string> known_names(const std::string& command) {
  std::vector<std::string> names;
  if (command == "new")
    for (const EmbeddedText& entry : all_templates()) names.emplace_back(entry.name);
  if (command == "materials")
    for (const LibraryMaterial& entry : material_library()) names.emplace_back(entry.name);
  return names;
}

}  // namespace

std::vector<CommandWords> command_words(const CLI::App& program) {
  std::vector<CommandWords> all{words_of(program)};
  for (const CLI::App* command : program.get_subcommands({})) {
    all.push_back(words_of(*command));
    for (OptionWords& argument : all.back().arguments)
      if (argument.choices.empty()) argument.choices = known_names(command->get_name());
  }
  return all;
}

}  // namespace kerf
