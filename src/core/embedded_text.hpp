// SPDX-License-Identifier: Apache-2.0
// A text file that the build embeds in the program (cmake/KerfEmbed.cmake).
#pragma once

#include <string_view>

namespace kerf {

struct EmbeddedText {
  std::string_view name;
  std::string_view text;
};

}  // namespace kerf
