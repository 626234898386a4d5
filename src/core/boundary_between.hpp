// SPDX-License-Identifier: Apache-2.0
// boundary_between() finds by halving where a predicate changes.
#pragma once

namespace kerf {

// Returns the last number found inside, on the way from one outside to one inside; 2^-40 of the way
// from the boundary.
template <class IsInside>
double boundary_between(double outside, double inside, const IsInside& is_inside) {
  constexpr int halvings = 40;
  for (int n = 0; n < halvings; ++n) {
    const double middle = 0.5 * (outside + inside);
    (is_inside(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace kerf
