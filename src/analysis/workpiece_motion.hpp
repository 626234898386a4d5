// SPDX-License-Identifier: Apache-2.0
// The motion that a case gives its bodies.
#pragma once

#include <array>

namespace kerf {

struct Body;
struct Case;
struct Workpiece;

// Returns the velocity at the middle of a body at the start, m/s.
std::array<double, 3> first_velocity(const Body& body, int dimension);

// Returns the velocity at which the bodies in the way of the jet move from the start on, m/s; zero
// where they do not share one.
std::array<double, 3> drift_of(const Case& description, const Workpiece& workpiece);

// Returns how far a body crosses the first jet at most, m: by its displacement, or at its velocity
// of the start, less the way of the nozzle, until the end of the run.
double way_across_jet(const Case& description, const Body& body);

}  // namespace kerf
