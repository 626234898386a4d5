// SPDX-License-Identifier: Apache-2.0
#include "simulation/breakdown.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace kerf {

void report_breakdown(const Breakdown& breakdown) {
  const std::string what = breakdown.fault ? fmt::format("has {}", breakdown.cause)
                                           : fmt::format("needs a time step of {:.3g} s ({})",
                                                         breakdown.dt, breakdown.cause);
  const Point& x = breakdown.position;
  throw UserError(
      fmt::format("the run broke down at t = {:.6g} s, step {}: particle {} of {} at "
                  "({:.6g}, {:.6g}, {:.6g}) m {}; lower time.courant (now {}) or a repulsion, and "
                  "look at the last frame",
                  breakdown.time, breakdown.step, breakdown.particle, breakdown.owner, x[0], x[1],
                  x[2], what, breakdown.courant),
      exit_run_failed);
}

}  // namespace kerf
