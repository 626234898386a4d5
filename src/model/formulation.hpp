// SPDX-License-Identifier: Apache-2.0
// The formulations that a case chooses among; each has a folder of src/ of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kerf {

enum class Formulation : std::uint8_t { standard, shinohara2004 };
inline constexpr std::array<std::string_view, 2> formulation_words{"standard", "shinohara2004"};

constexpr const char* formulation_name(Formulation formulation) {
  return formulation_words[static_cast<std::size_t>(formulation)].data();
}

}  // namespace kerf
