// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/completion.hpp"

namespace kerf {
namespace {

void print_completion(const CLI::App& program, const std::string& shell) {
  const auto commands = command_words(program);
  if (shell == "bash")
    fmt::print("{}", bash_completion(commands));
  else if (shell == "zsh")
    fmt::print("{}", zsh_completion(commands));
  else
    fmt::print("{}", fish_completion(commands));
}

}  // namespace

void add_completion_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "completion", "Print a script with which a shell completes command lines of kerf");
  auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "the shell: bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([&program, shell] { print_completion(program, *shell); });
}

}  // namespace kerf
