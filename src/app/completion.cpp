// SPDX-License-Identifier: Apache-2.0
#include "app/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/algorithm/string/replace.hpp>

namespace kerf {
namespace {

constexpr const char* licence = "# SPDX-License-Identifier: Apache-2.0";

bool takes_value(const OptionWords& option) {
  return !option.value.empty() || !option.choices.empty();
}

// A file is not offered for a number: "INT in [1 - 4096]", "FLOAT:POSITIVE".
bool takes_number(const OptionWords& option) {
  for (const char* type : {"INT", "UINT", "FLOAT"})
    if (option.value.starts_with(type)) return true;
  return false;
}

std::vector<std::string> names_of(const std::vector<OptionWords>& options) {
  std::vector<std::string> names;
  for (const OptionWords& option : options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> command_names(const std::vector<CommandWords>& commands) {
  std::vector<std::string> names;
  for (std::size_t n = 1; n < commands.size(); ++n) names.push_back(commands[n].name);
  return names;
}

std::vector<std::string> choices_of_arguments(const CommandWords& command) {
  std::vector<std::string> choices;
  for (const OptionWords& argument : command.arguments)
    choices.insert(choices.end(), argument.choices.begin(), argument.choices.end());
  return choices;
}

// Returns a text within single quotes of sh, zsh or fish.
std::string quoted(std::string text) {
  boost::replace_all(text, "'", "'\\''");
  return "'" + text + "'";
}

// Of the branches of `case "command word-before"`.
std::string bash_branches(const CommandWords& command) {
  std::string text;
  std::vector<std::string> with_files;
  for (const OptionWords& option : command.options) {
    if (!takes_value(option)) continue;
    for (const std::string& name : option.names) {
      const std::string pattern = fmt::format("\"{} {}\"", command.name, name);
      if (option.choices.empty())
        with_files.push_back(pattern);
      else
        text += fmt::format("    {}) words=\"{}\" ;;\n", pattern, fmt::join(option.choices, " "));
    }
  }
  if (!with_files.empty()) text += fmt::format("    {}) ;;\n", fmt::join(with_files, " | "));
  const auto arguments = choices_of_arguments(command);
  text += fmt::format(
      "    \"{} \"*) if [[ $word == -* ]]; then words=\"{}\"; else words=\"{}\"; fi ;;\n",
      command.name, fmt::join(names_of(command.options), " "), fmt::join(arguments, " "));
  return text;
}

// Returns the value of an option or the argument of a command for _arguments of zsh.
std::string zsh_values(const OptionWords& option) {
  if (takes_number(option)) return " ";
  if (option.choices.empty()) return "_files";
  return fmt::format("({})", fmt::join(option.choices, " "));
}
std::string zsh_description(std::string text) {
  for (const char* special : {"\\", "[", "]", ":"})
    boost::replace_all(text, special, std::string("\\") + special);
  return text;
}
std::string zsh_command(const CommandWords& command) {
  std::vector<std::string> parts;
  for (const OptionWords& option : command.options)
    for (const std::string& name : option.names) {
      const std::string value = takes_value(option) ? ":value:" + zsh_values(option) : "";
      parts.push_back(
          quoted(fmt::format("{}[{}]{}", name, zsh_description(option.description), value)));
    }
  for (const OptionWords& argument : command.arguments)
    parts.push_back(
        quoted(fmt::format("{}:{}:{}", argument.required ? "" : ":",
                           zsh_description(argument.names.front()), zsh_values(argument))));
  return fmt::format("    {}) _arguments {} ;;\n", command.name, fmt::join(parts, " "));
}

std::string fish_option(const std::string& condition, const OptionWords& option) {
  std::string line = "complete -c kerf" + condition;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.choices.empty())
    line += fmt::format(" -x -a {}", quoted(fmt::format("{}", fmt::join(option.choices, " "))));
  else if (takes_value(option))
    line += takes_number(option) ? " -x" : " -r";
  return line + " -d " + quoted(option.description) + "\n";
}

}  // namespace

std::string bash_completion(const std::vector<CommandWords>& commands) {
  std::string branches;
  for (std::size_t n = 1; n < commands.size(); ++n) branches += bash_branches(commands[n]);
  return fmt::format(
      "{}\n# Completes kerf in bash; made by \"kerf completion bash\".\n"
      "_kerf() {{\n"
      "  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" before=\"${{COMP_WORDS[COMP_CWORD-1]}}\" "
      "words=\"\"\n"
      "  if [[ $COMP_CWORD -eq 1 ]]; then\n    words=\"{} {}\"\n  else\n"
      "    case \"${{COMP_WORDS[1]}} $before\" in\n{}    esac\n  fi\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
      "}}\ncomplete -o default -F _kerf kerf\n",
      licence, fmt::join(command_names(commands), " "),
      fmt::join(names_of(commands.front().options), " "), branches);
}

std::string zsh_completion(const std::vector<CommandWords>& commands) {
  std::string list, branches;
  for (std::size_t n = 1; n < commands.size(); ++n) {
    list += " " + quoted(commands[n].name + ":" + zsh_description(commands[n].description));
    branches += zsh_command(commands[n]);
  }
  return fmt::format(
      "#compdef kerf\n{}\n# Completes kerf in zsh; made by \"kerf completion zsh\".\n"
      "_kerf() {{\n  local -a commands\n  commands=({})\n"
      "  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
      "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n"
      "  case $command in\n{}  esac\n}}\n_kerf \"$@\"\n",
      licence, list, branches);
}

std::string fish_completion(const std::vector<CommandWords>& commands) {
  std::string text =
      fmt::format("{}\n# Completes kerf in fish; made by \"kerf completion fish\".\n", licence);
  for (const OptionWords& option : commands.front().options)
    text += fish_option(" -n __fish_use_subcommand", option);
  for (std::size_t n = 1; n < commands.size(); ++n) {
    const CommandWords& command = commands[n];
    text += fmt::format("complete -c kerf -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                        quoted(command.description));
    const std::string condition = fmt::format(" -n '__fish_seen_subcommand_from {}'", command.name);
    for (const OptionWords& option : command.options) text += fish_option(condition, option);
    const auto choices = choices_of_arguments(command);
    if (!choices.empty())
      text += fmt::format("complete -c kerf{} -f -a '{}'\n", condition, fmt::join(choices, " "));
  }
  return text;
}

}  // namespace kerf
