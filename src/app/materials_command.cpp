// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "input/material_library.hpp"
#include "input/schema.hpp"
#include "input/units.hpp"

namespace kerf {

namespace {

struct MaterialsOptions {
  std::string name;
  bool page = false;
};

void print_library() {
  fmt::print("Materials of the library; \"kerf materials NAME\" shows the values of one:\n\n");
  for (const LibraryMaterial& entry : material_library())
    fmt::print("  {:<18} {:<8} {}{}\n", entry.name, kind_name(entry.kind), entry.title,
               entry.has_intervals() ? " (calibrate)" : "");
}

void print_values(const std::vector<LibraryValue>& values) {
  for (const LibraryValue& value : values) {
    fmt::print("  {:<21} {:<14} {}\n", value.name, value.written, value.source);
    if (!value.note.empty()) fmt::print("  {:<21} {:<14} ({})\n", "", "", value.note);
    if (value.interval)
      fmt::print("  {:<21} {:<14} calibrate (kerf study): {} to {} by {}\n", "", "",
                 value.interval->low_written, value.interval->high_written,
                 value.interval->sources);
  }
}

// Returns the keys that the library leaves out and a case takes from the defaults.
void print_defaults(const LibraryMaterial& entry) {
  const Material material = entry.material();
  std::set<std::string> conditions{formulation_name(Formulation::standard)};
  for (const Key* key : keys_stored_in("materials", material, conditions)) {
    const bool number = key->kind == ValueKind::number || key->kind == ValueKind::quantity;
    if (number && !key->computed() && !entry.find(key->name))
      fmt::print("  {:<21} {:<14} default of a case file\n", key->name,
                 shortest(standard_number(*key)));
  }
}

void print_material(const std::string& name) {
  const LibraryMaterial* entry = find_library_material(name);
  if (!entry) {
    std::vector<std::string> names;
    for (const LibraryMaterial& other : material_library()) names.emplace_back(other.name);
    refuse_name(fmt::format("there is no material \"{}\" in the library", name), name, names);
  }
  fmt::print("{} ({}): {}\n\n", entry->name, kind_name(entry->kind), entry->title);
  fmt::print("  {:<21} {:<14} {}\n", "key", "value", "source");
  print_values(entry->values);
  if (entry->kind == MaterialKind::elastic)
    fmt::print("  {:<21} {:<14}\n", "criterion",
               word_of(entry->material().criterion, bond_criterion_words));
  print_defaults(*entry);
  if (entry->known.empty()) return;
  fmt::print("\n{}\n\n", known_heading);
  print_values(entry->known);
}

void show(const MaterialsOptions& options) {
  if (options.page)
    fmt::print("{}", materials_page());
  else if (options.name.empty())
    print_library();
  else
    print_material(options.name);
}

}  // namespace

void add_materials_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("materials", "Show the material library");
  auto options = std::make_shared<MaterialsOptions>();
  auto* name =
      command->add_option("name", options->name, "Name of a material; without it, all are listed");
  auto* page = command->add_flag("--page", options->page, "Print docs/materials.md instead");
  page->excludes(name);
  command->callback([options] { show(*options); });
}

}  // namespace kerf
