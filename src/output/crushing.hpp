// SPDX-License-Identifier: Apache-2.0
// A solid that the pressure of a jet alone compresses to the volume at which it fails: its strength
// and its fracture energy hardly count then (docs/theory/total_lagrangian.md).
#pragma once

#include <optional>
#include <string>

namespace kerf {

struct Body;
struct Case;
struct Jet;

// Returns the stagnation pressure of a jet, Pa.
double stagnation_pressure(const Case& description, const Jet& jet);

struct Crushing {
  double pressure = 0.0;  // Pa, the stagnation pressure of the jet
  double limit = 0.0;     // Pa, that compresses the solid, at its width, until it fails
};

// Returns both if the jet crushes the body, an elastic one of a material that can break.
std::optional<Crushing> crushing_of(const Case& description, const Body& body, const Jet& jet);

// Says so, with the remedy, without a full stop.
std::string crushing_sentence(const Case& description, const Body& body, const Jet& jet,
                              const Crushing& crushing);

}  // namespace kerf
