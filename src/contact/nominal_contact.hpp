// SPDX-License-Identifier: Apache-2.0
// nominal_contact() computes the kernel sum of a particle over another body in first contact: the
// lattice of the other fills a half-space, and its first layer is the mean of the two spacings
// away, as if both were one lattice. It is computed once, on the host.
#pragma once

#include <cmath>

#include "core/vector.hpp"

namespace kerf {

struct NominalContact {
  double kernel_sum = 0.0;  // phi_c, 1
  double slope = 0.0;       // of the kernel_sum over the approach, 1/m
};

// Returns the sums over a lattice of `spacing` whose first layer is `gap` away, with a particle
// opposite (offset = 0) or half a spacing aside (1/2). A lattice of more layers than `most` in the
// support is as good as continuous: the same half space is summed over so many.
template <int D, class Kernel>
NominalContact half_space_sums(double gap, double spacing, double h, double offset) {
  constexpr double most = 64.0;
  const double reach = Kernel::support * h;
  if (reach > most * spacing) {
    gap += 0.5 * (reach / most - spacing);
    spacing = reach / most;
  }
  const int layers = static_cast<int>(std::ceil(reach / spacing)) + 1;
  NominalContact sum;
  for (int n = 0; n < layers; ++n)
    for (int k = -layers; k <= layers; ++k)
      for (int l = D == 3 ? -layers : 0; l <= (D == 3 ? layers : 0); ++l) {
        const double across = (k + offset) * spacing, along = D == 3 ? (l + offset) * spacing : 0.0;
        const double deep = gap + n * spacing;
        const double distance = std::sqrt(deep * deep + across * across + along * along);
        const double volume = std::pow(spacing, D);
        sum.kernel_sum += volume * Kernel::value(distance, h);
        sum.slope -= volume * Kernel::derivative(distance, h) * deep / distance;
      }
  return sum;
}

template <int D, class Kernel>
NominalContact nominal_contact(double own_spacing, double spacing, double h) {
  const double gap = 0.5 * (own_spacing + spacing);
  const auto opposite = half_space_sums<D, Kernel>(gap, spacing, h, 0.0);
  const auto aside = half_space_sums<D, Kernel>(gap, spacing, h, 0.5);
  return {0.5 * (opposite.kernel_sum + aside.kernel_sum), 0.5 * (opposite.slope + aside.slope)};
}

}  // namespace kerf
