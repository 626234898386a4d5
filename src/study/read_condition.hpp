// SPDX-License-Identifier: Apache-2.0
// This header declares the readers of values and conditions on a command line.
#pragma once

#include <string>

#include "input/units.hpp"
#include "study/goals.hpp"

namespace kerf {

// Reads a quantity with its unit, or a pure number where the SI unit is "".
Quantity read_value(const std::string& text, const std::string& si_unit);

// Reads "METRIC >= VALUE" or "METRIC <= VALUE". A metric with a unit needs a value with one. Throws
// UserError.
Condition read_where(const std::string& text, int dimension);

}  // namespace kerf
