// SPDX-License-Identifier: Apache-2.0
// The water of jets that a run holds at one time: what its jets have emitted, but no more than can
// be in the domain, because what leaves it is removed.
#pragma once

namespace kerf {

struct Case;
struct Jet;

// Returns the largest number of particles of the water of a jet that are in the domain at one time
// until the time `end`, s. It is the least of three bounds:
// - what the jet emits until then, or while a window that travels with the nozzle passes a place;
// - what fills the domain;
// - where nothing moves or falls and no two symmetry planes face each other: what the jet emits in
//   the time that water at a tenth of its speed takes for the longest way through the domain, and
//   what fills the box around the bodies, which may hold water for any time.
double most_jet_water(const Case& description, const Jet& jet, double end);

// Returns the number of particles that the simulated part of a jet emits until then.
double emitted_water(const Case& description, const Jet& jet, double end);

}  // namespace kerf
