// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_failure.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/error.hpp"

namespace kerf {

void report_run_failure(const RunFailure& failure) {
  const std::string what =
      failure.fault ? fmt::format("has {}", failure.cause)
                    : fmt::format("needs a time step of {:.3g} s ({})", failure.dt, failure.cause);
  const std::string_view strength =
      failure.never_breaks
          ? "its material never breaks, so that nothing limits how far it is deformed: give it a "
            "strength, or the jet less pressure; else "
          : "";
  const Point& x = failure.position;
  throw UserError(
      fmt::format("the run broke down at t = {:.6g} s, step {}: particle {} of {} at "
                  "({:.6g}, {:.6g}, {:.6g}) m {}; {}lower time.courant (now {}){}, and look at the "
                  "last frame",
                  failure.time, failure.step, failure.particle, failure.owner, x[0], x[1], x[2],
                  what, strength, failure.courant, failure.repels ? " or a repulsion" : ""),
      exit_run_failed);
}

}  // namespace kerf
