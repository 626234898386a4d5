// SPDX-License-Identifier: Apache-2.0
// BondStrain is the strain of a bond of the total Lagrangian solid, by two measures that a fracture
// criterion combines. The strain tensors of both particles give the strain of the neighbourhood,
// free of hourglass noise but smeared over the kernel: beside a crack that opens, all bonds of a
// band seem strained, and at its tip none is strained as much as it should be. The bond's own
// change of length distinguishes the bonds that cross the crack. In a uniform strain both measures
// agree.
#pragma once

#include <cmath>

#include "core/host_device.hpp"

namespace kerf {

// Stretches as lambda^2 - 1.
template <class T>
struct BondStrain {
  T mean = 0;      // N . (E_i + E_j) N, by the tensors of its ends; 0 where passes() is false
  T own = 0;       // |x_ij|^2 / R^2 - 1: by its own length
  T prepared = 0;  // mean of prepare() of its ends

  // Whether it is stretched, by its own length at least half as much as by the tensors.
  KERF_FUNCTION bool is_opening() const { return mean > T(0) && own > T(0.5) * mean; }
};

// Whether a stretch, given as lambda^2 - 1, is above this Hencky strain ln(lambda); 0 = no limit.
template <class T>
KERF_FUNCTION bool is_above(T stretch, T strain) {
  // exp(2 e) - 1 > 2 e: most bonds need no exponential.
  return strain > T(0) && stretch > T(2) * strain && stretch > std::expm1(T(2) * strain);
}

}  // namespace kerf
