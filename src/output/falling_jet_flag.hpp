// SPDX-License-Identifier: Apache-2.0
// Water that gravity speeds up on its way keeps its width and loses density where it would narrow
// (docs/limits.md).
#pragma once

#include <optional>
#include <string>

#include "output/validity.hpp"

namespace kerf {

struct Case;
struct Jet;

// Returns the share of its section by which a jet would narrow from the nozzle to the first body in
// its way, or to the end of the domain: 1 - V0 / sqrt(V0^2 + 2 g h), with g along the jet. 0 where
// gravity does not speed it up.
double narrowing_by_gravity(const Case& description, const Jet& jet);

// Returns both speeds and the share of the jet that would narrow most; none where that is little.
std::optional<std::string> falling_jet(const Case& description);

// Returns the flag on it.
std::optional<ValidityFlag> falling_jet_flag(const Case& description);

}  // namespace kerf
