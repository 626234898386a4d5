// SPDX-License-Identifier: Apache-2.0
// Materials that every case may name, each value with its source. They come from materials/*.toml,
// which the build puts into the program.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/embedded_text.hpp"
#include "model/case.hpp"

namespace kerf {

// What decides which keys a material has, as the schema names it.
std::set<std::string> material_conditions(const Material& material, Formulation formulation);

// What a material may be known to have although no law of Kerf uses it yet.
struct KnownQuantity {
  std::string_view name;
  std::string_view unit;  // SI; "" = a pure number
  std::string_view meaning;
};
inline constexpr std::string_view known_heading =
    "Known besides, used by no run unless a case gives it as a key:";
std::span<const KnownQuantity> known_quantities();

struct LibraryValue {
  std::string name;     // a key of [materials.NAME], or one of known_quantities()
  double value = 0.0;   // SI
  std::string written;  // as the file has it: "100 kPa"
  std::string source;
  std::string note;  // conditions and range; may be empty
};

struct LibraryMaterial {
  std::string name;
  MaterialKind kind = MaterialKind::elastic;
  PlasticLaw plasticity = PlasticLaw::none;
  std::string title;
  std::vector<LibraryValue> values;
  std::vector<LibraryValue> known;  // used by no law yet

  // The value of a key, or null when `values` leaves it out.
  const LibraryValue* find(std::string_view key) const;
  std::set<std::string> conditions() const;
  // What `values` leaves out has its default in a case file. The speed of sound is 0, as that of a
  // water is found when the case is read. `shinohara2004` knows no law of plasticity.
  Material material(Formulation formulation = Formulation::standard) const;
};

// The files of materials/ by name, in alphabetical order.
std::span<const EmbeddedText> material_files();
// A mistake in the text is one of the program, whose texts are built in: std::logic_error.
LibraryMaterial read_library_material(std::string_view name, std::string_view text);

std::span<const LibraryMaterial> material_library();
// Null when the library has no such material.
const LibraryMaterial* find_library_material(std::string_view name);
std::string kind_name(MaterialKind kind);
// docs/materials.md.
std::string materials_page();

}  // namespace kerf
