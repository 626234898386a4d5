// SPDX-License-Identifier: Apache-2.0
// This header lists the exit codes of the program.
#pragma once

#include "core/error.hpp"

namespace kerf {

inline constexpr int exit_usage = 2, exit_internal = 70;

struct ExitCode {
  const char* code;
  const char* meaning;
};
// docs/results.md has the same rows.
inline constexpr ExitCode exit_codes[] = {
    {"0", "success"},
    {"1", "the case is wrong"},
    {"2", "the command line is wrong"},
    {"3", "the run failed (a value that is not a number, a runaway particle)"},
    {"4",
     "files or folders: disk full, not writable, missing, a damaged checkpoint or one of another "
     "run"},
    {"70", "an error of the program itself; please report it"},
    {"129, 130, 143", "stopped by SIGHUP, SIGINT, SIGTERM; the state is saved"},
};

}  // namespace kerf
