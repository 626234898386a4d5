// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "case/material_library.hpp"
#include "case/problems.hpp"
#include "case/schema.hpp"
#include "case/units.hpp"
#include "core/error.hpp"

namespace kerf {

namespace {

std::string with_unit(const LibraryValue& value, MaterialKind kind) {
  const Key* key = find_key("materials", value.key, {kind_name(kind)});
  return key->unit.empty() ? shortest(value.value)
                           : write_quantity(value.value, std::string(key->unit));
}

void print_list() {
  fmt::print("Materials of the library; \"kerf materials NAME\" shows the values of one:\n\n");
  for (const LibraryMaterial& entry : material_library())
    fmt::print("  {:<10} {:<8} {}\n", entry.name, kind_name(entry.kind), entry.summary);
}

void print_material(const std::string& name) {
  const LibraryMaterial* entry = find_library_material(name);
  if (!entry) {
    std::vector<std::string> names;
    for (const LibraryMaterial& other : material_library()) names.emplace_back(other.name);
    const std::string guess = closest(name, names);
    throw UserError(fmt::format("there is no material \"{}\" in the library. {}Allowed: {}.", name,
                                guess.empty() ? "" : fmt::format("Did you mean \"{}\"? ", guess),
                                fmt::join(names, ", ")));
  }
  fmt::print("{} ({}): {}\n\n", entry->name, kind_name(entry->kind), entry->summary);
  fmt::print("  {:<21} {:<14} {}\n", "key", "value", "source");
  for (const LibraryValue& value : entry->values)
    fmt::print("  {:<21} {:<14} {}\n", value.key, with_unit(value, entry->kind), value.source);
}

}  // namespace

void add_materials_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("materials", "Show the material library");
  auto name = std::make_shared<std::string>();
  command->add_option("name", *name, "Which material; without it, all are listed");
  command->callback([name] { name->empty() ? print_list() : print_material(*name); });
}

}  // namespace kerf
