// SPDX-License-Identifier: Apache-2.0
// From positions to deformation and stress. With R = X_j - X_i and w_ij of solid_fields.hpp,
//   H_i = F_i - 1 = (sum_j w_ij (u_j - u_i) (x) R) B_i / V_i.
// The force needs of a particle one tensor only, which joins stress and hourglass control,
//   A_i = P_i B_i - mu_i H_i,   mu of hourglass_modulus.hpp,   see bond_force.hpp.
#pragma once

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

  KERF_FUNCTION void operator()(Index i) const {
    if (solid.loose[i]) {  // it keeps the gradient with which it came loose
      solid.traction[i] = Matrix<D, Real>::zero();
      return;
    }
    const Index end = solid.bond_begin[i + 1], images = solid.first_image(i);
    auto sum = gather<DirectEnd>(i, solid.bond_begin[i], images);
    if (images < end) sum += gather<BondEnd>(i, images, end);
    const auto& medium = solid.medium(i);
    const Matrix<D, Real> h = sum * solid.correction[i];
    solid.gradient[i] = h;
    const Matrix<D, Real> stress = first_piola(response.stress(solid, i, h), h);
    solid.traction[i] = medium.volume() * (stress * solid.correction[i]);
    solid.traction[i] += -solid.hourglass[i] * h;
  }

 private:
  // sum_j w_ij (u_j - u_i) (x) R over bonds k of particle i.
  template <class End>
  KERF_FUNCTION Matrix<D, Real> gather(Index i, Index k, Index end) const {
    auto sum = Matrix<D, Real>::zero();
    for (; k < end; ++k) {
      const End j = solid.template bond_end<End>(k);
      const Vector<D, Real> bond = solid.weight[k] * solid.reference_bond(i, j);
      add_outer(sum, solid.displacement_bond(i, j), bond);
    }
    return sum;
  }
};

}  // namespace kerf
