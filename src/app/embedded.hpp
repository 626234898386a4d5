// SPDX-License-Identifier: Apache-2.0
// Texts that the build puts into the program (cmake/KerfEmbed.cmake).
#pragma once

#include <span>

#include "core/embedded_text.hpp"

namespace kerf {

// The files of cases/, in alphabetical order.
std::span<const EmbeddedText> case_templates();
// The meshes beside those files, text STL, under their names without the extension.
std::span<const EmbeddedText> case_meshes();
// The files of cases/studies/, in alphabetical order.
std::span<const EmbeddedText> study_templates();
// The files of validation/, named "FOLDER/FILE", in alphabetical order.
std::span<const EmbeddedText> validation_texts();

}  // namespace kerf
