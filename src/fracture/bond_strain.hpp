// SPDX-License-Identifier: Apache-2.0
// How a bond of the total Lagrangian solid is strained: what a fracture criterion looks at. A
// criterion is a struct with
//   prepare(medium, green)     a number per particle, worked out once; handed back in the bond
//   breaks(bond, medium)       whether a bond of this medium breaks
// It sees a bond from either end with the same numbers, so that both ends decide alike.
//
// Two measures go together. The mean of both particles' tensors along the bond is free of hourglass
// noise, but is smeared over the kernel: beside a crack that opens, all bonds of a band seem
// strained. The bond's own change of length tells those that cross the crack from those that do
// not. In a uniform strain both are the same.
#pragma once

#include "core/tensor.hpp"

namespace kerf {

template <class T>
struct BondStrain {
  T mean =
      0;      // lambda^2 - 1 = N . (E_i + E_j) N: stretch along the bond by the tensors of its ends
  T own = 0;  // lambda^2 - 1 = |x_ij|^2 / R^2 - 1: stretch of the bond itself
  T prepared = 0;  // mean of the numbers prepared for its ends
};

}  // namespace kerf
