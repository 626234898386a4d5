// SPDX-License-Identifier: Apache-2.0
// Quantities as people write them, "300 MPa" or "1200 mm/min", in SI units (by UDUNITS-2).
#pragma once

#include <string>
#include <string_view>

namespace kerf {

struct Quantity {
  double value = 0.0;   // in the SI unit asked for
  std::string problem;  // why there is no value; empty when there is one
};

// Reads `text` as a number and a unit of the dimension of `si_unit`. May be called from any thread.
Quantity read_quantity(std::string_view text, const std::string& si_unit);

// A number as the shortest text that reads back to the same bits.
std::string shortest(double value);
// shortest(value) and the unit, "0.002 m"; read_quantity gives the same bits back.
std::string write_quantity(double value, const std::string& si_unit);

// What a unit measures ("a speed") and a quantity of it as one would write it ("5 m/s").
std::string dimension_of(const std::string& si_unit);
std::string example_of(const std::string& si_unit);

}  // namespace kerf
