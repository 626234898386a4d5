// SPDX-License-Identifier: Apache-2.0
// HourglassViscosity damps hourglass modes after plastic flow. There the hourglass modulus has
// fallen (solid/hourglass_modulus.hpp), and the motion that a particle's gradient does not
// represent would be free. It is damped as in finite elements with one point of integration
// (Flanagan & Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679). The power  sum_i eta_i sum_j
// w_ij |gamma_ij|^2, gamma_ij = Fdot_i R - v_ij,  is Rayleigh's function, and the force is minus
// its gradient, as that of the elastic control is minus the gradient of an energy:
//   m_i a_i = sum_j w_ij [(eta_i + eta_j) v_ij - (eta_i Fdot_i + eta_j Fdot_j) R].
// The elastic hourglass force is part of solid/bond_force.hpp.
#pragma once

#include "solid/stress_response.hpp"

namespace kerf {

// eta = xi (zeta E - mu) h / c: a share of the stiffness that was lost, over the time in which a
// wave crosses the kernel.
inline constexpr double hourglass_damping = 0.05;  // xi

template <int D, class P>
KERF_FUNCTION typename P::Real hourglass_viscosity(const SolidView<D, P>& solid, Index i) {
  using Real = typename P::Real;
  if (!solid.flows(i)) return Real(0);
  const auto& medium = solid.medium(i);
  const Real lost = solid.elastic_share[i] * medium.hourglass_modulus() - solid.ends[i].hourglass;
  return Real(hourglass_damping) * lost * medium.smoothing_length / medium.bond_wave_speed();
}

// Computes eta_i Fdot_i of every particle, Pa.
template <int D, class P>
struct RateTraction {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    const Real viscosity = solid.detached[i] ? Real(0) : hourglass_viscosity(solid, i);
    solid.hourglass_viscosity[i] = viscosity;
    auto sum = Matrix<D, Real>::zero();
    if (viscosity > Real(0))
      for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
        if (!solid.is_intact(i, k)) continue;
        const BondEnd j = solid.bond_end(i, k);
        const Vector<D, Real> bond = solid.reference_bond(i, j);
        add_outer(sum, solid.velocity_bond(i, j), solid.weight(i, k, j, bond) * bond);
      }
    solid.rate_traction[i] =
        viscosity * (sum * Matrix<D, Real>::from(solid.correction[i].matrix()));
  }
};

template <int D, class P>
struct HourglassViscosity {
  using Real = typename P::Real;

  // Adds the force on i and the power of its own share.
  template <class End>
  KERF_FUNCTION void add(const SolidView<D, P>& solid, const ChosenBond<D, Real, End>& chosen,
                         Vector<D, Real>& force, Real& power) const {
    const auto& [i, j, bond] = chosen;
    const Real own = solid.hourglass_viscosity[i];
    const Real both = own + solid.hourglass_viscosity[j.particle];
    if (!(both > Real(0))) return;
    const Vector<D, Real> speed = solid.velocity_bond(i, j);
    const Vector<D, Real> fitted = solid.rate_traction[i] * bond.reference;
    force += bond.weight * (both * speed - fitted -
                            solid.image(j, solid.rate_traction[j.particle]) * bond.reference);
    if (!(own > Real(0))) return;
    const Vector<D, Real> misfit = fitted - own * speed;
    power += bond.weight / own * dot(misfit, misfit);
  }
};

}  // namespace kerf
