// SPDX-License-Identifier: Apache-2.0
// The message of a failed run.
#pragma once

#include <cstdint>
#include <string>

#include "model/point.hpp"

namespace kerf {

struct RunFailure {
  double time = 0.0;  // s
  std::uint64_t step = 0;
  std::uint32_t particle = 0;  // id
  std::string owner;           // its body or jet, as in "body 'plate'"
  Point position{};            // m
  bool fault = false;          // the state is broken, not only the step too short
  double dt = 0.0;             // s, the step it would need
  std::string cause;           // the limit, or the fault
  bool never_breaks = false;   // the particle is of a solid without a strength
  bool repels = false;         // a body has a `repulsion`
  double courant = 0.0;        // of the run
};

// Throws a UserError (exit_run_failed) with time, particle, cause and remedy.
[[noreturn]] void report_run_failure(const RunFailure& failure);

}  // namespace kerf
