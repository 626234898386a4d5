// SPDX-License-Identifier: Apache-2.0
// A field of the particles where the engine keeps it, for programs that read it without a copy.
#pragma once

#include <cstddef>
#include <string>

namespace kerf {

// Entries of `components` numbers of one type; valid until the next step.
struct FieldSpan {
  enum class Number { float32, float64, uint8, uint16, uint32 };
  std::string name;
  const void* data = nullptr;
  Number number = Number::float32;
  std::size_t entries = 0, components = 1;
};

}  // namespace kerf
