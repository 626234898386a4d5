// SPDX-License-Identifier: Apache-2.0
#include "case/material_library.hpp"

#include <set>

#include "case/schema.hpp"
#include "core/error.hpp"

namespace kerf {

namespace {

constexpr std::string_view shinohara = "Shinohara, Okabe & Nakayama (2004), sec. 4";
constexpr std::string_view shinohara_viscosity = "Shinohara, Okabe & Nakayama (2004), sec. 2.4";
constexpr std::string_view gray = "Gray, Monaghan & Swift (2001), colliding rubber cylinders";

constexpr MaterialField all_fields[] = {
    {"density", &Material::density},
    {"youngs_modulus", &Material::youngs_modulus},
    {"poisson_ratio", &Material::poisson_ratio},
    {"failure_strain", &Material::failure_strain},
    {"fracture_energy", &Material::fracture_energy},
    {"viscosity", &Material::viscosity},
    {"tait_exponent", &Material::tait_exponent},
    {"artificial_linear", &Material::artificial_linear},
    {"artificial_quadratic", &Material::artificial_quadratic},
    {"artificial_softening", &Material::artificial_softening},
};

const LibraryMaterial library[] = {
    {"water",
     MaterialKind::water,
     "Water at 20 C; its speed of sound is ten times the fastest speed of the case, eq. (18)",
     {{"density", 1000.0, "reference density of the equation of state, rounded from 998 kg/m3"},
      {"viscosity", 1.0e-3, "water at 20 C, rounded from 1.002 mPa s (IAPWS 2008)"},
      {"tait_exponent", 7.0,
       "Shinohara, Okabe & Nakayama (2004), eq. (15), after Batchelor (1967)"},
      {"artificial_linear", 0.01, shinohara_viscosity},
      {"artificial_quadratic", 0.0, shinohara_viscosity},
      {"artificial_softening", 0.1, shinohara_viscosity}}},
    {"tofu",
     MaterialKind::elastic,
     "Bean curd as the founding paper has it; real tofu is nearly incompressible",
     {{"density", 940.0, shinohara},
      {"youngs_modulus", 1.0e5, shinohara},
      {"poisson_ratio", 0.3, shinohara},
      {"failure_strain", 0.1, shinohara},
      {"fracture_energy", 0.0, "unknown; the paper has a strain"},
      {"artificial_linear", 2.5, shinohara_viscosity},
      {"artificial_quadratic", 2.5, shinohara_viscosity},
      {"artificial_softening", 0.1, shinohara_viscosity}}},
    {"rubber",
     MaterialKind::elastic,
     "Rubber of the colliding rings of Gray, Monaghan & Swift (2001)",
     {{"density", 1000.0, "chosen: the published problem is scaled to a density of 1"},
      {"youngs_modulus", 1.0e7, gray},
      {"poisson_ratio", 0.3975, gray},
      {"failure_strain", 0.0, "never fractures: the published rings bounce"},
      {"fracture_energy", 0.0, "never fractures"},
      {"artificial_linear", 1.0, "chosen: enough to stop particles from crossing"},
      {"artificial_quadratic", 1.0, "chosen: enough to stop particles from crossing"},
      {"artificial_softening", 0.01, "Monaghan (1992), eta^2 = 0.01 h^2"}}},
};

}  // namespace

std::vector<MaterialField> material_fields(MaterialKind kind) {
  const std::set<std::string> conditions{kind_name(kind)};
  std::vector<MaterialField> fields;
  for (const MaterialField& field : all_fields)
    if (find_key("materials", field.key, conditions)->applies_under(conditions))
      fields.push_back(field);
  return fields;
}

Material LibraryMaterial::material() const {
  Material result;
  result.name = name;
  result.kind = kind;
  result.source = "Kerf's library: " + std::string(summary);
  for (const MaterialField& field : material_fields(kind)) {
    bool found = false;
    for (const LibraryValue& value : values) {
      if (value.key != field.key) continue;
      result.*field.member = value.value;
      found = true;
    }
    require(found, "a material of the library lacks a value");
  }
  return result;
}

std::span<const LibraryMaterial> material_library() {
  return library;
}

const LibraryMaterial* find_library_material(std::string_view name) {
  for (const LibraryMaterial& entry : library)
    if (entry.name == name) return &entry;
  return nullptr;
}

std::string kind_name(MaterialKind kind) {
  return kind == MaterialKind::water ? "water" : "elastic";
}

}  // namespace kerf
