// SPDX-License-Identifier: Apache-2.0
// Bonds across a crack whose faces slide. The criteria look at stretch. A particle on the line of a
// crack may keep bonds to both of its faces; where these move past one another they turn and hardly
// stretch, its fit is a mean of two motions, and what holds the faces together is the control of
// hourglasses alone. Such a bond is one that the fits of its ends miss by far:
//   gamma_ij = (H_i + H_j)/2 R - u_ij,   |gamma_ij| > 8 e |R|,
// with e the strain at which it would break. Only beside bonds that are broken: in a body that is
// whole a misfit is noise or a steep gradient. Of this program; eight is chosen as the most of
// which less than a twentieth of the elastic energy is left in the control, in a plate with cracks
// of mode II loading (validation/standard-kalthoff).
#pragma once

#include "solid/solid_medium.hpp"

namespace kerf {

inline constexpr double severing_misfit = 8.0;

// Of a bond of this medium: |gamma|^2 and |R|^2.
template <class T>
KERF_FUNCTION bool is_severed(T misfit_squared, T length_squared, const SolidMedium<T>& solid) {
  const T limit = T(severing_misfit) * solid.failure_strain;
  return limit > T(0) && misfit_squared > limit * limit * length_squared;
}

}  // namespace kerf
