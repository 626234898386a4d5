// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/embedded.hpp"
#include "model/case.hpp"
#include "output/files.hpp"

namespace kerf {

namespace {

// Returns the description of a template from its first line, "# name: description".
std::string_view first_sentence(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  const auto colon = line.find(": ");
  return colon == std::string_view::npos ? line : line.substr(colon + 2);
}

void list_templates() {
  fmt::print("Case templates; \"kerf new NAME > my.toml\" writes one:\n\n");
  const auto list = [](std::span<const EmbeddedText> texts) {
    for (const EmbeddedText& entry : texts)
      fmt::print("  {:<18} {}\n", entry.name, first_sentence(entry.text));
  };
  list(case_templates());
  fmt::print("\nStudies, for \"kerf study\":\n\n");
  list(study_templates());
}

// Writes the meshes that a template names into the current folder, from which its copy reads them,
// unless files of these names exist.
void write_meshes(std::string_view text) {
  for (const EmbeddedText& mesh : case_meshes()) {
    const std::string file = fmt::format("{}.stl", mesh.name);
    if (text.find(fmt::format("\"{}\"", file)) == std::string_view::npos) continue;
    const bool is_there = std::filesystem::exists(file);
    if (!is_there) write_file(file, mesh.text);
    fmt::print(stderr, "{} {}: the case reads it from its own folder.\n", file,
               is_there ? "exists already and was not changed" : "was written");
  }
}

void print_template(const std::string& name) {
  std::vector<std::string> names;
  for (const EmbeddedText& entry : all_templates()) {
    if (entry.name == name) {
      write_meshes(entry.text);
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
