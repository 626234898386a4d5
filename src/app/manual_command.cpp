// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/manual_page.hpp"

namespace kerf {

void add_manual_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "manual", "Print the manual page; \"kerf manual | man -l -\" shows it");
  command->callback([&program] { fmt::print("{}", manual_page(command_words(program))); });
}

}  // namespace kerf
