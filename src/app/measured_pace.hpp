// SPDX-License-Identifier: Apache-2.0
// The pace of a run on this machine, measured by a pilot run: the case itself at a spacing at which
// its whole run takes a second or two. It has the geometry and the physics of the run, so that it
// counts the costly debris and contacts of later times, and the steps that squeezed particles
// shorten. docs/performance.md has the rules.
#pragma once

#include <chrono>

#include "app/run_cost.hpp"

namespace kerf {

using WallClock = std::chrono::steady_clock;

// How long a pilot run may take; the first of both limits that is reached ends it.
struct PilotLimits {
  double processor = 2.0;  // s of its thread, with the steps alone
  // Of the time of day, with everything: what a busy machine leaves of that.
  WallClock::time_point until = WallClock::time_point::max();
  double slower = 1.0;  // the time of day over that of the processor, as far as is known
};

// Returns the limits within which an answer that was begun then is there after five seconds, also
// on a busy machine: what follows the pilot run takes as long as what was done before it, and
// advice.
PilotLimits limits_of_answer(WallClock::time_point begun);

// Makes a pilot run of 10^4 particles at most. Returns the typical pace, which says why, where this
// build cannot run the case, all pilots fail, the time does not suffice for one, or the pilot was
// too small or too short to tell anything.
Pace measured_pace(const Case& description, const DerivedNumbers& numbers, int threads,
                   const PilotLimits& limits = {});

// Returns the case of the pilot run: with its bodies and jets coarsened, `stretch` times as much as
// is needed.
Case pilot_case(const Case& description, const DerivedNumbers& numbers, double stretch = 1.0);

// What a pilot run has seen.
struct PilotResult {
  double particles = 0.0;       // at the start
  double seconds = 0.0;         // of the processor, for its steps
  double wall_seconds = 0.0;    // of the time of day, for the same
  double particle_steps = 0.0;  // the sum of its particles over its steps
  double steps = 0.0;
  double expected_steps = 0.0;  // in the same time, by the estimate for its spacing
  double share = 0.0;           // of the time until the likely end of the run
  double particle_row = 0.0;    // s, of each particle for a row of series.csv
  double bond_share = 0.0;
};

// Whether it has made steps and particles enough to tell the speed of `particles` of them.
bool is_telling(const PilotResult& run, double particles);

// Returns the steps of the whole run over those of its estimate: what the pilot has seen of them,
// and for the time that it has not seen the geometric mean of that and of the estimate.
double step_factor(const PilotResult& run);

}  // namespace kerf
