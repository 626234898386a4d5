// SPDX-License-Identifier: Apache-2.0
// Materials that every case may name, each value with its source.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace kerf {

// The numbers of a material and the keys they have in a case file.
struct MaterialField {
  std::string_view key;
  double Material::*member;
};
// The fields a material of that kind has, but for the speed of sound, in the order of the schema.
std::vector<MaterialField> material_fields(MaterialKind kind);

struct LibraryValue {
  std::string_view key;
  double value;  // SI
  std::string_view source;
};

struct LibraryMaterial {
  std::string_view name;
  MaterialKind kind;
  std::string_view summary;
  std::vector<LibraryValue> values;

  // Its speed of sound is 0, as that of a water is found when the case is read.
  Material material() const;
};

std::span<const LibraryMaterial> material_library();
// Null when the library has no such material.
const LibraryMaterial* find_library_material(std::string_view name);
std::string kind_name(MaterialKind kind);

}  // namespace kerf
