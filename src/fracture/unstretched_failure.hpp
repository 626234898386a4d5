// SPDX-License-Identifier: Apache-2.0
// Two kinds of failure are independent of the fracture criterion, because they stretch no bond:
// bonds across sliding crack faces fail by their misfit, and a crushed particle fails in
// compression.
#pragma once

#include "core/matrix.hpp"
#include "fracture/bond_criterion.hpp"

namespace kerf {

// A particle on the line of a crack may keep bonds to both of its faces; where these move past one
// another the bonds turn and hardly stretch, the particle's deformation gradient is a mean of two
// motions, and the hourglass control alone holds the faces together. The deformation gradients of
// the ends of such a bond miss it by far:
//   gamma_ij = (H_i + H_j)/2 R - u_ij,   |gamma_ij| > 8 e |R|,
// with e the failure strain. Only particles with broken bonds are tested: in a fully bonded body a
// misfit is noise or a steep gradient. This rule is Kerf's own; with a factor of eight less than a
// twentieth of the elastic energy is left in the control, in a plate with cracks of mode II loading
// (validation/standard-kalthoff).
inline constexpr double largest_misfit = 8.0;  // over the failure strain

// `misfit_squared`: |gamma|^2; `length_squared`: |R|^2.
template <class T>
KERF_FUNCTION bool fails_by_misfit(T misfit_squared, T length_squared,
                                   const BreakableSolid<T>& solid) {
  const T limit = T(largest_misfit) * solid.failure_strain;
  return limit > T(0) && misfit_squared > limit * limit * length_squared;
}

// Whether the ends of a bond would press on one another as the faces of a crack if it broke
// (contact/debris_contact.hpp): they are closer than their mean spacing, m, and than they were laid
// out. Such a bond does not fail by its misfit, since the contact would store energy that no bond
// had. `length_squared`: |R|^2, `growth`: |x|^2 - |R|^2.
template <class T>
KERF_FUNCTION bool ends_press(T length_squared, T growth, T spacing) {
  const T rest = spacing * spacing < length_squared ? spacing * spacing : length_squared;
  return length_squared + growth < T(1 - 1e-5) * rest;  // less than rounding is no contact
}

// A solid that is compressed below a fifth of its volume, or turned inside out, fails in
// compression: all bonds of the particle break. The elastic laws depend on C = F^T F only, cannot
// tell a volume J from -J, and become as stiff as 1 / J^2.
inline constexpr double least_volume = 0.2;  // J = det F

// Stands for compressive failure among the numbers that criteria prepare, none of which is as
// large.
template <class T>
inline constexpr T compressive_failure = T(1e30);

// `h`: F - 1. A solid that cannot break does not fail in compression either.
template <int D, class T>
KERF_FUNCTION bool fails_in_compression(const BondedSolid<T>& solid, const Matrix<D, T>& h) {
  return solid.bonds_can_break() && !(determinant(identity<D, T>() + h) >= T(least_volume));
}

}  // namespace kerf
