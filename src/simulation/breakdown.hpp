// SPDX-License-Identifier: Apache-2.0
// A run that has broken down, in one sentence.
#pragma once

#include <cstdint>
#include <string>

#include "case/case.hpp"

namespace kerf {

struct Breakdown {
  double time = 0.0;  // s
  std::uint64_t step = 0;
  std::uint32_t particle = 0;  // id
  std::size_t source = 0;      // body, or number of bodies + jet
  Point position{};            // m
  bool fault = false;          // the state is broken, not only the step too short
  double dt = 0.0;             // s, the step it would need
  std::string cause;
};

// Throws a UserError (exit_run_failed) that says when, where, what and what to do.
[[noreturn]] void report_breakdown(const Case& description, const Breakdown& breakdown);

}  // namespace kerf
