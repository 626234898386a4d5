// SPDX-License-Identifier: Apache-2.0
#include "app/manual_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/exit_codes.hpp"
#include "core/version.hpp"

namespace kerf {
namespace {

// Returns a text of which troff takes no character for a command.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
      result += std::string("\\&") + c;
    else
      result += c;
  }
  return result;
}

std::string sentence(std::string text) {
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

std::string option_entry(const OptionWords& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back("\\fB" + plain(name) + "\\fR");
  std::string entry = fmt::format(".TP\n{}", fmt::join(names, ", "));
  const bool is_argument = option.names.front().front() != '-';
  if (!option.choices.empty() && !is_argument)
    entry += " " + plain(fmt::format("{}", fmt::join(option.choices, "|")));
  else if (!option.value.empty() && !is_argument)
    entry += " \\fI" + plain(option.value) + "\\fR";
  entry += "\n" + plain(sentence(option.description));
  if (!option.standard.empty()) entry += plain(fmt::format(" Default: {}.", option.standard));
  return entry + "\n";
}

std::string synopsis(const CommandWords& command) {
  std::string line = fmt::format("\\fBkerf {}\\fR [\\fIoptions\\fR]", plain(command.name));
  for (const OptionWords& argument : command.arguments) {
    const std::string name = "\\fI" + plain(argument.names.front()) + "\\fR";
    line += argument.required ? " " + name : " [" + name + "]";
  }
  return line;
}

std::string command_section(const CommandWords& command) {
  std::string text = fmt::format(".SS {}\n{}\n.PP\n{}\n", plain(command.name), synopsis(command),
                                 plain(sentence(command.description)));
  for (const OptionWords& argument : command.arguments) text += option_entry(argument);
  for (const OptionWords& option : command.options) text += option_entry(option);
  return text;
}

}  // namespace

std::string manual_page(const std::vector<CommandWords>& commands) {
  const CommandWords& program = commands.front();
  std::string text = fmt::format(
      ".TH KERF 1 \"\" \"kerf {0}\" \"User Commands\"\n"
      ".SH NAME\nkerf \\- simulator of water\\-jet cutting\n"
      ".SH SYNOPSIS\n\\fBkerf\\fR \\fIcommand\\fR [\\fIoptions\\fR]\n"
      ".SH DESCRIPTION\n{1}\n"
      "A case file states machine, material and workpiece; \\fBkerf new\\fR writes commented "
      "examples, \\fBkerf check\\fR tells what a run will cost, and \\fBkerf run\\fR computes it "
      "and writes a report.\n",
      program_version, plain(sentence(program.description)));
  text += ".SH OPTIONS\n";
  for (const OptionWords& option : program.options) text += option_entry(option);
  text += ".SH COMMANDS\n";
  for (std::size_t n = 1; n < commands.size(); ++n) text += command_section(commands[n]);
  text += ".SH EXIT STATUS\n";
  for (const ExitCode& entry : exit_codes)
    text += fmt::format(".TP\n{}\n{}\n", plain(entry.listed()), plain(sentence(entry.meaning)));
  text +=
      ".SH ENVIRONMENT\n.TP\nKERF_SIMD\nThe instruction set of the SIMD kernels: baseline, avx2 or "
      "avx512. The default is the widest that the processor has.\n";
  return text;
}

}  // namespace kerf
