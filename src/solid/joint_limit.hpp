// SPDX-License-Identifier: Apache-2.0
// The longest stable step of a particle with bonds to unlike media, by a bound of Gershgorin's kind
// (docs/theory/time_step.md). Particle i adds at most  1/2 s_i sum_j w_ij |u_j - u_i|^2  to the
// second variation of the energy,
//   s_i = max(L_i V_i |B_i|, mu_i),   L_i: largest eigenvalue of its elasticity tensor,
// because the stress acts on the fitted part of the motion and the hourglass control on the rest of
// it. So a bond is at most as stiff as a spring k_ij = w_ij (s_i + s_j) and at most as damped as a
// damper g_ij between its ends, and the explicit step is stable if for each particle
//   dt^2 S_i + 2 dt G_i <= 2 m_i,   S_i = sum_j k_ij,   G_i = sum_j g_ij.
// A light particle beside stiff ones has their stiffness and its own mass.
#pragma once

#include <cmath>

#include "solid/bond_force.hpp"

namespace kerf {

// Returns the largest eigenvalue of the elasticity tensor on displacement gradients, Pa: that of a
// change of volume or of shape. In 2D the strain is plane.
template <int D, class Real>
KERF_FUNCTION double largest_stiffness(const Medium<Real>& medium) {
  const double bulk = double(medium.bulk_modulus), shear = double(medium.shear_modulus);
  const double volume = D == 3 ? 3.0 * bulk : 2.0 * (bulk + shear / 3.0);
  return volume > 2.0 * shear ? volume : 2.0 * shear;
}

template <int D, class P>
class JointLimit {
 public:
  using Real = typename P::Real;

  KERF_FUNCTION explicit JointLimit(const SolidView<D, P>& solid) : solid_(solid) {}

  // Returns the longest stable step of particle i, s.
  KERF_FUNCTION double stable_step(Index i) const {
    const double own = stiffness(i);
    double springs = 0.0, dampers = 0.0;  // S_i, N/m; G_i, N s/m
    for (Index k = solid_.bonds.first(i); k < solid_.bonds.last(i); ++k) {
      if (!solid_.is_intact(i, k)) continue;
      const BondEnd j = solid_.bond_end(i, k);
      const auto bond = solid_.reference_bond(i, j);
      const double weight = double(solid_.weight(i, k, j, bond));
      springs += weight * (own + stiffness(j.particle) + excess(i, j.particle));
      dampers += weight * damping(i, j, double(norm(bond)));
    }
    const double mass = double(solid_.medium(i).mass);
    return 2.0 * mass / (dampers + std::sqrt(dampers * dampers + 2.0 * mass * springs));
  }

 private:
  // Returns s_i, Pa. The largest sum over a row of a symmetric matrix bounds its eigenvalues.
  KERF_FUNCTION double stiffness(Index i) const {
    if (solid_.detached[i]) return 0.0;
    const auto& medium = solid_.medium(i);
    const Matrix<D, double> correction = solid_.correction[i].matrix();
    double largest = 0.0;
    for (int a = 0; a < D; ++a) {
      double row = 0.0;
      for (int b = 0; b < D; ++b) row += std::abs(correction(a, b));
      largest = row > largest ? row : largest;
    }
    const double fitted =
        largest_stiffness<D>(medium) * double(medium.reference_volume()) * largest;
    const double hourglass = double(solid_.ends[i].hourglass);
    return fitted > hourglass ? fitted : hourglass;
  }
  // Returns what the pressure of two nearly incompressible solids adds to a bond, Pa: its energy
  // 1/2 V K' (div u)^2 is at most 1/2 K' D sum_j w_ij |u_j - u_i|^2, K' the modulus that acts by
  // the density.
  KERF_FUNCTION double excess(Index i, Index j) const {
    const double a = double(solid_.medium(i).excess_bulk_modulus);
    const double b = double(solid_.medium(j).excess_bulk_modulus);
    return a > 0.0 && b > 0.0 ? D * (a + b) : 0.0;
  }
  // Returns the damping of a bond over its weight, Pa s: of its viscosity at the current speed, and
  // of the hourglass viscosity of both ends.
  KERF_FUNCTION double damping(Index i, const BondEnd& j, double distance) const {
    const auto law = solid_.viscosity_law(i, j.particle);
    const double length = double(law.length);
    const double theta = length * double(norm(solid_.velocity_bond(i, j))) / distance;
    const double own = solid_.any_flows ? double(solid_.hourglass_viscosity[i]) : 0.0;
    const double other = solid_.any_flows ? double(solid_.hourglass_viscosity[j.particle]) : 0.0;
    return double(law.density) * length *
               (double(law.linear) + 2.0 * double(law.quadratic) * theta) +
           own + other;
  }

  const SolidView<D, P>& solid_;
};

}  // namespace kerf
