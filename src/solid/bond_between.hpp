// SPDX-License-Identifier: Apache-2.0
// The bond between two particles of the solid, broken or not, in the lists of solid_fields.hpp.
#pragma once

#include "exec/exec.hpp"

namespace kerf {

inline constexpr Index no_bond = 0xffffffffu;

// Place of b among the neighbours of a, which ascend; or no_bond.
KERF_FUNCTION Index bond_between(const Index* bond_begin, const Index* neighbour, Index a,
                                 Index b) {
  Index low = bond_begin[a], high = bond_begin[a + 1];
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    if (neighbour[middle] < b)
      low = middle + 1;
    else
      high = middle;
  }
  return low < bond_begin[a + 1] && neighbour[low] == b ? low : no_bond;
}

}  // namespace kerf
