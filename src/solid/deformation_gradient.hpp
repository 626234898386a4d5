// SPDX-License-Identifier: Apache-2.0
// Deform computes the deformation gradient and the stress of each particle from the displacements.
// With R = X_j - X_i and w_ij of solid/bond_weight.hpp,
//   H_i = F_i - 1 = (sum_j w_ij (u_j - u_i) (x) R) B_i / V_i.
// The force (solid/bond_force.hpp) needs of a particle one tensor only, which joins stress and
// hourglass control,
//   A_i = s_i P_i B_i - mu_i H_i,   s of limit_break_energy.hpp, mu of hourglass_modulus.hpp.
#pragma once

#include "simd/run_in_blocks.hpp"
#include "solid/stress_response.hpp"

namespace kerf {

template <int D, class P, class Response>
struct Deform {
  using Real = typename P::Real;
  using BondGradient = BondGradientSum<D, Real>;
  SolidView<D, P> solid;
  Response response;
  BlockResults<BondGradient> known_sums{};  // of particles that the SIMD kernels compute

  KERF_FUNCTION void take(const BlockResults<BondGradient>& sums) { known_sums = sums; }

  KERF_FUNCTION void operator()(Index i) const {
    if (solid.asleep[i]) return;
    auto& traction = solid.ends[i].traction;
    if (solid.detached[i]) {  // it keeps its last gradient
      traction = Matrix<D, Real>::zero();
      return;
    }
    const bool is_known = known_sums.are_known() && !solid.several_bodies[i];
    const BondGradient bonds = is_known ? known_sums[i] : sum_all(i);
    solid.stretch[i] = bonds.stretch;
    const auto& medium = solid.medium(i);
    const Matrix<D, double> correction = solid.correction[i].matrix();
    const auto h = Matrix<D, Real>::from(Matrix<D, double>::from(bonds.sum) * correction);
    solid.gradient[i] = h;
    const Matrix<D, Real> stress = first_piola(response.stress(solid, i, h), h);
    traction = medium.reference_volume() * solid.elastic_share[i] *
               (stress * Matrix<D, Real>::from(correction));
    traction += -solid.ends[i].hourglass * h;
  }

 private:
  KERF_NOINLINE KERF_FUNCTION BondGradient sum_all(Index i) const {
    const Index end = solid.bonds.last(i), images = solid.first_image(i);
    BondGradient result{Matrix<D, Real>::zero(), Real(0)};
    result.sum = sum_bonds<DirectEnd>(i, solid.bonds.first(i), images, result.stretch);
    if (images < end) result.sum += sum_bonds<BondEnd>(i, images, end, result.stretch);
    return result;
  }

  // Returns sum_j w_ij (u_j - u_i) (x) R over bonds k of particle i; `stretch` becomes the largest
  // |x|^2 / R^2 - 1 of one.
  template <class End>
  KERF_FUNCTION Matrix<D, Real> sum_bonds(Index i, Index k, Index end, Real& stretch) const {
    auto sum = Matrix<D, Real>::zero();
    for (; k < end; ++k) {
      if (!solid.is_intact(i, k)) continue;
      const End j = solid.template bond_end<End>(i, k);
      const BondGeometry<D, Real> bond = solid.bond_geometry(i, k, j);
      const Real growth = square_growth(bond.reference, bond.change);
      const Real square = dot(bond.reference, bond.reference);
      if (growth > stretch * square) stretch = growth / square;
      add_bond_gradient(sum, bond);
    }
    return sum;
  }
};

}  // namespace kerf
