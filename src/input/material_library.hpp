// SPDX-License-Identifier: Apache-2.0
// Materials that every case may name, each value with its source. They come from materials/*.toml,
// which the build puts into the program.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/embedded_text.hpp"
#include "model/formulation.hpp"
#include "model/material.hpp"

namespace kerf {

// Returns the conditions on which the keys of a material depend, in the words of the schema.
std::set<std::string> material_conditions(const Material& material, Formulation formulation);

// A property of a material that no law of Kerf uses.
struct KnownQuantity {
  std::string_view name;
  std::string_view unit;  // SI; "" = a pure number
  std::string_view meaning;
};
inline constexpr std::string_view known_heading =
    "Known besides, used by no run unless a case gives it as a key:";
std::span<const KnownQuantity> known_quantities();

// What the sources of a value leave open. The value is to be calibrated by a test cut.
struct ValueInterval {
  double low = 0.0, high = 0.0;           // SI
  std::string low_written, high_written;  // as the file has them
  std::string sources;
};

struct LibraryValue {
  std::string name;     // a key of [materials.NAME], or one of known_quantities()
  double value = 0.0;   // SI
  std::string written;  // as the file has it: "100 kPa"
  std::string source;
  std::string note;  // conditions and range; may be empty
  std::optional<ValueInterval> interval{};

  // Returns the interval in words, "fracture_energy 400 J/m2 to 1800 J/m2"; empty if there is none.
  std::string interval_text() const;
};

struct LibraryMaterial {
  std::string name;
  MaterialKind kind = MaterialKind::elastic;
  PlasticLaw plasticity = PlasticLaw::none;
  std::optional<BondCriterion> criterion;  // none: the default of a case file
  std::string title;
  std::vector<LibraryValue> values;
  std::vector<LibraryValue> known;  // values that no law uses

  // Returns the value of a key, or null if `values` has none.
  const LibraryValue* find(std::string_view key) const;
  std::set<std::string> conditions() const;
  // Returns the material of a case. Values that are missing in `values` have the defaults of a case
  // file. The sound speed is 0, because that of water is computed when the case is read. In the
  // formulation `shinohara2004` the material has no law of plasticity, no fracture energy, and
  // breaks at its failure strain.
  Material material(Formulation formulation = Formulation::standard) const;
  // Returns what Material::uncalibrated says of a material that is based on this one: the intervals
  // of the values that it has from here.
  std::string uncalibrated(const Material& material, Formulation formulation) const;
  bool has_intervals() const;
};

// The files of materials/ by name, in alphabetical order.
std::span<const EmbeddedText> material_files();
// Reads the text of a material file. Throws std::logic_error if it is not valid, because the texts
// are part of the program.
LibraryMaterial read_library_material(std::string_view name, std::string_view text);

std::span<const LibraryMaterial> material_library();
// Returns the material of that name, or null if the library has none.
const LibraryMaterial* find_library_material(std::string_view name);
std::string kind_name(MaterialKind kind);
// Returns the text of docs/materials.md.
std::string materials_page();

}  // namespace kerf
