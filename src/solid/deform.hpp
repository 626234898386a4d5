// SPDX-License-Identifier: Apache-2.0
// From positions to deformation and stress. With R = X_j - X_i and w_ij of solid_fields.hpp,
//   H_i = F_i - 1 = (sum_j w_ij (u_j - u_i) (x) R) B_i / V_i.
// The force needs of a particle one tensor only, which joins stress and hourglass control,
//   A_i = P_i B_i - mu_i H_i,   mu of hourglass_modulus.hpp,   see bond_force.hpp.
#pragma once

#include "lanes/walk_in_blocks.hpp"
#include "solid/break_account.hpp"

namespace kerf {

template <int D, class P, class Response>
struct Deform {
  using Real = typename P::Real;
  using Gathered = BondGradient<D, Real>;
  SolidView<D, P> solid;
  Response response;
  BlockResults<Gathered> gathered{};  // of bonds that are not mixed

  KERF_FUNCTION void take(const BlockResults<Gathered>& known) { gathered = known; }

  KERF_FUNCTION void operator()(Index i) const {
    auto& traction = solid.ends[i].traction;
    if (solid.loose[i]) {  // it keeps the gradient with which it came loose
      traction = Matrix<D, Real>::zero();
      return;
    }
    const bool known = gathered.are_known() && !solid.mixed[i];
    const Gathered bonds = known ? gathered[i] : gather_all(i);
    solid.stretch[i] = bonds.stretch;
    const auto& medium = solid.medium(i);
    const Matrix<D, Real> h = bonds.sum * solid.correction[i];
    solid.gradient[i] = h;
    const Matrix<D, Real> stress = first_piola(response.stress(solid, i, h), h);
    traction = medium.volume() * (stress * solid.correction[i]);
    traction += -solid.ends[i].hourglass * h;
  }

 private:
  KERF_APART KERF_FUNCTION Gathered gather_all(Index i) const {
    const Index end = solid.bonds.last(i), images = solid.first_image(i);
    Gathered result{Matrix<D, Real>::zero(), Real(0)};
    result.sum = gather<DirectEnd>(i, solid.bonds.first(i), images, result.stretch);
    if (images < end) result.sum += gather<BondEnd>(i, images, end, result.stretch);
    return result;
  }

  // sum_j w_ij (u_j - u_i) (x) R over bonds k of particle i, and the largest stretch of one,
  // |x|^2 / R^2 - 1 = (2 R + u) . u / R^2.
  template <class End>
  KERF_FUNCTION Matrix<D, Real> gather(Index i, Index k, Index end, Real& stretch) const {
    auto sum = Matrix<D, Real>::zero();
    for (; k < end; ++k) {
      if (!solid.is_whole(i, k)) continue;
      const End j = solid.template bond_end<End>(i, k);
      const Vector<D, Real> bond = solid.reference_bond(i, j);
      const Vector<D, Real> change = solid.displacement_bond(i, j);
      const Real longer = dot(Real(2) * bond + change, change), square = dot(bond, bond);
      if (longer > stretch * square) stretch = longer / square;
      add_outer(sum, change, solid.weight(i, k, j, bond) * bond);
    }
    return sum;
  }
};

// `Loop`, a Deform, of those alone that lost bonds.
template <int D, class P, class Loop>
struct DeformBroken {
  Loop deform;
  BreakAccounts<D, P> accounts;

  KERF_FUNCTION void operator()(Index i) const {
    if (accounts.of[i].is_open) deform(i);
  }
};

}  // namespace kerf
