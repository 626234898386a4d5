// SPDX-License-Identifier: Apache-2.0
// Solid that is squeezed below a fifth of its volume, or turned inside out, is crushed: no bond of
// it holds. The laws of elasticity see C = F^T F only, cannot tell a volume J from -J, and become
// as stiff as 1 / J^2; the criteria look at stretch, and pass by what is only squeezed.
#pragma once

#include "core/matrix.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

inline constexpr double least_volume = 0.2;  // J = det F

// Stands for "crushed" among the numbers that criteria prepare, none of which is that large.
template <class T>
inline constexpr T crushed = T(1e30);

// `h`: F - 1. What can't break is not crushed.
template <int D, class T>
KERF_FUNCTION bool is_crushed(const SolidMedium<T>& solid, const Matrix<D, T>& h) {
  return solid.can_break() && !(determinant(identity<D, T>() + h) >= T(least_volume));
}

}  // namespace kerf
