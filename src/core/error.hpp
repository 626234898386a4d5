// SPDX-License-Identifier: Apache-2.0
// The program throws two kinds of error. A UserError can be corrected by the user; its sentence
// states the cause and the remedy. All others are errors of the program.
#pragma once

#include <stdexcept>
#include <string>

#include "core/public_symbol.hpp"

namespace kerf {

// An error that the user can correct. The message is shown unchanged; the program ends with
// `exit_code()` (1 = bad input, 3 = the run failed, 4 = files or folders).
class KERF_PUBLIC UserError : public std::runtime_error {
 public:
  explicit UserError(const std::string& message, int exit_code = 1)
      : std::runtime_error(message), exit_code_(exit_code) {}
  int exit_code() const { return exit_code_; }

 private:
  int exit_code_;
};

inline constexpr int exit_bad_input = 1;
inline constexpr int exit_run_failed = 3;
inline constexpr int exit_files = 4;

// A broken invariant of the program itself.
inline void require(bool condition, const char* what) {
  if (!condition) throw std::logic_error(std::string("internal error: ") + what);
}

}  // namespace kerf
