// SPDX-License-Identifier: Apache-2.0
// Where it is pulled, a nearly incompressible solid has only the bulk modulus that its bonds carry
// (docs/theory/nearly_incompressible.md).
#pragma once

#include <optional>

#include "output/validity.hpp"

namespace kerf {

struct Case;

// Returns the flag on the body of the largest Poisson's ratio; none if no body is affected.
std::optional<ValidityFlag> tension_flag(const Case& description);

}  // namespace kerf
