// SPDX-License-Identifier: Apache-2.0
// This header lists the exit codes of the program.
#pragma once

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace kerf {

inline constexpr int exit_usage = 2, exit_internal = 70;

struct ExitCode {
  std::vector<int> codes;
  const char* meaning;
  // Returns "129, 130, 143".
  std::string listed() const { return fmt::format("{}", fmt::join(codes, ", ")); }
};
// docs/results.md has the same rows.
inline const std::array<ExitCode, 7> exit_codes{{
    {{0}, "success"},
    {{exit_bad_input}, "the case is wrong"},
    {{exit_usage}, "the command line is wrong"},
    {{exit_run_failed},
     "the run failed (a value that is not a number, a runaway particle), or there is not enough "
     "memory"},
    {{exit_files},
     "files or folders: disk full, not writable, missing, a damaged checkpoint or one of another "
     "run"},
    {{exit_internal}, "an error of the program itself; please report it"},
    {{128 + SIGHUP, 128 + SIGINT, 128 + SIGTERM},
     "stopped by SIGHUP, SIGINT, SIGTERM; the state is saved"},
}};

}  // namespace kerf
