// SPDX-License-Identifier: Apache-2.0
#include "app/case_form.hpp"

#include <fmt/format.h>

#include "app/embedded.hpp"
#include "app/template_files.hpp"
#include "input/key_text.hpp"
#include "input/material_library.hpp"
#include "input/schema.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

// Returns the kind of material that a key names: "" = every kind; "none" = no material.
std::string material_kind(std::string_view section, const Key& key) {
  if (key.name == "base") return "";
  if (key.name != "material") return "none";
  if (section == "machine" || section == "jet") return kind_name(MaterialKind::water);
  return section == "workpiece" ? kind_name(MaterialKind::elastic) : "";
}

Json key_json(std::string_view section, const Key& key) {
  Json json = {{"name", key.name},
               {"label", key_label(key)},
               {"unit", key.unit},
               {"allowed", allowed_text(key)},
               {"default", key.required() ? "" : plain_text(default_text(key))},
               {"required", key.required()},
               {"help", key_help(key)}};
  if (key.kind == ValueKind::word) json["choices"] = key.choices;
  if (key.kind == ValueKind::flag) json["choices"] = {"true", "false"};
  if (const std::string kind = material_kind(section, key); kind != "none") json["material"] = kind;
  return json;
}

}  // namespace

Json form_schema() {
  Json sections = Json::array(), materials = Json::array(), templates = Json::array();
  for (const SchemaSection& section : schema()) {
    Json keys = Json::array();
    for (const Key& key : section.keys) keys.push_back(key_json(section.name, key));
    sections.push_back({{"name", section.name},
                        {"sentence", plain_text(section.sentence)},
                        {"keys", std::move(keys)}});
  }
  for (const LibraryMaterial& entry : material_library())
    materials.push_back(
        {{"name", entry.name}, {"kind", kind_name(entry.kind)}, {"title", entry.title}});
  for (const EmbeddedText& entry : case_templates())
    templates.push_back({{"name", entry.name}, {"title", template_title(entry.text)}});
  return {{"sections", std::move(sections)},
          {"materials", std::move(materials)},
          {"templates", std::move(templates)}};
}

}  // namespace kerf
