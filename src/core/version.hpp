// SPDX-License-Identifier: Apache-2.0
// This file states the version of the program and the compiler that built it.
#pragma once

#include <string>

namespace kerf {

inline constexpr const char* program_version = KERF_VERSION;

inline std::string compiler_name() {
#if defined(__clang__)
  return std::string("clang ") + __clang_version__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

}  // namespace kerf
