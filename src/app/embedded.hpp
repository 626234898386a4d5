// SPDX-License-Identifier: Apache-2.0
// This header declares the texts that the build embeds in the program (cmake/KerfEmbed.cmake).
#pragma once

#include <span>
#include <vector>

#include "core/embedded_text.hpp"

namespace kerf {

// Returns the files of cases/ in alphabetical order.
std::span<const EmbeddedText> case_templates();
// Returns the meshes of cases/, text STL, by their names without the extension.
std::span<const EmbeddedText> case_meshes();
// Returns the files of cases/studies/ in alphabetical order.
std::span<const EmbeddedText> study_templates();
// Returns what `kerf new` knows: cases, then studies.
inline std::vector<EmbeddedText> all_templates() {
  std::vector<EmbeddedText> texts(case_templates().begin(), case_templates().end());
  texts.insert(texts.end(), study_templates().begin(), study_templates().end());
  return texts;
}
// Returns the files of validation/, named "FOLDER/FILE", in alphabetical order.
std::span<const EmbeddedText> validation_texts();
// Returns the files of experiments/, named in the same way.
std::span<const EmbeddedText> experiment_texts();

}  // namespace kerf
