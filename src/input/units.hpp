// SPDX-License-Identifier: Apache-2.0
// Conversion of quantities such as "300 MPa" or "1200 mm/min" to SI units (by UDUNITS-2).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kerf {

struct Quantity {
  double value = 0.0;   // in the requested SI unit
  std::string problem;  // why there is no value; empty when there is one
};

// Reads `text` as a number and a unit of the dimension of `si_unit`. May be called from any thread.
Quantity read_quantity(std::string_view text, const std::string& si_unit);

// Returns a number as the shortest text that is read back to the same bits.
std::string shortest(double value);
// Returns shortest(value) and the unit, "0.002 m"; read_quantity() returns the same bits.
std::string write_quantity(double value, const std::string& si_unit);
// Returns it as a message shows it: with six digits, angles in degrees. A bound is rounded to the
// side on which it is allowed, so that what the message says is accepted.
enum class Bound : std::uint8_t { none, least, most };
std::string show_quantity(double value, const std::string& si_unit, Bound bound = Bound::none);

// Return what a unit measures ("a speed") and an example of such a quantity ("5 m/s").
std::string dimension_of(const std::string& si_unit);
std::string example_of(const std::string& si_unit);

}  // namespace kerf
