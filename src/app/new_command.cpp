// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/embedded.hpp"
#include "app/template_files.hpp"

namespace kerf {

namespace {

void list_templates() {
  fmt::print("Case templates; \"kerf new NAME > my.toml\" writes one:\n\n");
  const auto list = [](std::span<const EmbeddedText> texts) {
    for (const EmbeddedText& entry : texts)
      fmt::print("  {:<18} {}\n", entry.name, template_title(entry.text));
  };
  list(case_templates());
  fmt::print("\nStudies, for \"kerf study\":\n\n");
  list(study_templates());
}

void print_template(const std::string& name) {
  std::vector<std::string> names;
  for (const EmbeddedText& entry : all_templates()) {
    if (entry.name == name) {
      for (const std::string& sentence : write_meshes(entry.text, "."))
        fmt::print(stderr, "{}\n", sentence);
      fmt::print("{}", entry.text);
      return;
    }
    names.emplace_back(entry.name);
  }
  refuse_name(fmt::format("there is no case template \"{}\"", name), name, names);
}

}  // namespace

void add_new_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("new", "Print a commented case or study as a template");
  auto name = std::make_shared<std::string>();
  command->add_option("name", *name, "Name of a case; without it, all are listed");
  command->callback([name] { name->empty() ? list_templates() : print_template(*name); });
}

}  // namespace kerf
