// SPDX-License-Identifier: Apache-2.0
// This header declares the scripts and style sheets of web/, which the build embeds where npm can
// make them.
#pragma once

#include <span>
#include <string_view>

#include "core/embedded_text.hpp"

namespace kerf {

std::span<const EmbeddedText> viewer_files();

// Returns "script" or "style" of a report, "study_script" or "study_style" of a study,
// "edit_script" or "edit_style" of the editor of cases; empty where the program was built without
// npm.
inline std::string_view viewer_text(std::string_view name) {
  for (const EmbeddedText& file : viewer_files())
    if (file.name == name) return file.text;
  return {};
}

}  // namespace kerf
