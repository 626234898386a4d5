// SPDX-License-Identifier: Apache-2.0
// How a bond of the total Lagrangian solid is strained: what a fracture criterion looks at. A
// criterion is a struct with
//   prepare(medium, green)     a number per particle, worked out once; its mean is in the bond
//   passes(prepared, medium)   whether this number asks for a look at the tensors along the bond
//   breaks(bond, medium)       whether a bond of this medium breaks
// It sees a bond from either end with the same numbers, so that both ends decide alike.
//
// Two measures go together. The tensors of both particles say how the neighbourhood is strained,
// free of hourglass noise but smeared over the kernel: beside a crack that opens, all bonds of a
// band seem strained, and at its tip none is strained as much as it should. The bond's own change
// of length tells those that cross the crack from those that do not. In a uniform strain both
// agree.
#pragma once

#include <cmath>

#include "exec/host_device.hpp"

namespace kerf {

// Stretches as lambda^2 - 1.
template <class T>
struct BondStrain {
  T mean = 0;      // N . (E_i + E_j) N: along the bond, by the tensors of its ends; 0 unless passed
  T own = 0;       // |x_ij|^2 / R^2 - 1: of the bond itself
  T prepared = 0;  // mean of the numbers prepared for its ends

  // It is stretched, and takes at least half of what the tensors say of its direction.
  KERF_FUNCTION bool is_opening() const { return mean > T(0) && own > T(0.5) * mean; }
};

// Whether a stretch, given as lambda^2 - 1, is above this Hencky strain ln(lambda); 0 = no limit.
template <class T>
KERF_FUNCTION bool is_above(T stretch, T strain) {
  // exp(2 e) - 1 > 2 e: most bonds need no exponential.
  return strain > T(0) && stretch > T(2) * strain && stretch > std::expm1(T(2) * strain);
}

}  // namespace kerf
