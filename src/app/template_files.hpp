// SPDX-License-Identifier: Apache-2.0
// This header declares what kerf new and the editor of cases know of a template.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

// Returns the description of a template from its first line, "# name: description".
std::string_view template_title(std::string_view text);

// Writes the meshes that a template names into the folder of its copy, which reads them from there,
// unless files of these names exist. Returns a sentence for each of them.
std::vector<std::string> write_meshes(std::string_view text, const std::filesystem::path& folder);

}  // namespace kerf
