// SPDX-License-Identifier: Apache-2.0
// From positions to deformation and stress. With R = X_j - X_i and w_ij of solid_fields.hpp,
//   H_i = F_i - 1 = (sum_j w_ij (u_j - u_i) (x) R) B_i / V_i.
// The force needs of a particle one tensor only, which joins stress and hourglass control,
//   A_i = P_i B_i - mu_i H_i,   mu of hourglass_modulus.hpp,   see bond_force.hpp.
#pragma once

#include "lanes/packed_bonds.hpp"
#include "solid/respond.hpp"

namespace kerf {

template <int D, class P>
struct Displace {
  SolidView<D, P> solid;
  const Vector<D, double>* position;

  KERF_FUNCTION void operator()(Index i) const {
    solid.displacement[i] = position[i] - solid.reference[i];
  }
};

template <int D, class P, class Response>
struct Deform {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  Response response;
  const BondGradient<D, Real>* gathered;  // of bonds that are not mixed; or null

  KERF_FUNCTION void operator()(Index i) const {
    if (solid.loose[i]) {  // it keeps the gradient with which it came loose
      solid.traction[i] = Matrix<D, Real>::zero();
      return;
    }
    const bool known = gathered != nullptr && !solid.mixed[i];
    const BondGradient<D, Real> bonds = known ? gathered[i] : gather_all(i);
    solid.stretch[i] = bonds.stretch;
    const auto& medium = solid.medium(i);
    const Matrix<D, Real> h = bonds.sum * solid.correction[i];
    solid.gradient[i] = h;
    const Matrix<D, Real> stress = first_piola(response.stress(solid, i, h), h);
    solid.traction[i] = medium.volume() * (stress * solid.correction[i]);
    solid.traction[i] += -solid.hourglass[i] * h;
  }

 private:
  KERF_FUNCTION BondGradient<D, Real> gather_all(Index i) const {
    const Index end = solid.bond_begin[i + 1], images = solid.first_image(i);
    BondGradient<D, Real> result{Matrix<D, Real>::zero(), Real(0)};
    result.sum = gather<DirectEnd>(i, solid.bond_begin[i], images, result.stretch);
    if (images < end) result.sum += gather<BondEnd>(i, images, end, result.stretch);
    return result;
  }

  // sum_j w_ij (u_j - u_i) (x) R over bonds k of particle i, and the largest stretch of one,
  // |x|^2 / R^2 - 1 = (2 R + u) . u / R^2.
  template <class End>
  KERF_FUNCTION Matrix<D, Real> gather(Index i, Index k, Index end, Real& stretch) const {
    auto sum = Matrix<D, Real>::zero();
    for (; k < end; ++k) {
      const Real weight = solid.weight[k];
      if (!(weight > Real(0))) continue;
      const End j = solid.template bond_end<End>(k);
      const Vector<D, Real> bond = solid.reference_bond(i, j);
      const Vector<D, Real> change = solid.displacement_bond(i, j);
      const Real longer = dot(Real(2) * bond + change, change), square = dot(bond, bond);
      if (longer > stretch * square) stretch = longer / square;
      add_outer(sum, change, weight * bond);
    }
    return sum;
  }
};

}  // namespace kerf
