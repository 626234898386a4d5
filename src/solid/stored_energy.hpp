// SPDX-License-Identifier: Apache-2.0
// energy_of() computes the energy that a particle of the solid stores: V psi(F), and the potential
// of the hourglass control 1/2 mu_i sum_j w_ij |F_i R - x_ij|^2, of which the force is minus the
// exact gradient. It is in double, so that the difference of two totals keeps enough digits.
#pragma once

#include "parallel/ordered_sum.hpp"
#include "solid/stress_response.hpp"

namespace kerf {

// Returns sum_j w_ij |F_i R - x_ij|^2.
template <int D, class P>
KERF_FUNCTION double misfit(const SolidView<D, P>& solid, Index i) {
  const auto h = Matrix<D, double>::from(solid.gradient[i]);
  double sum = 0.0;
  for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
    if (!solid.is_intact(i, k)) continue;
    const BondEnd j = solid.bond_end(i, k);
    auto gamma = h * solid.template reference_bond<double>(i, j);  // H R - u
    gamma -= solid.template displacement_bond<double>(i, j);
    sum += double(solid.weight(i, k, j, solid.reference_bond(i, j))) * dot(gamma, gamma);
  }
  return sum;
}

// The stored energy of one particle, or of all.
struct SolidEnergy {
  double elastic = 0.0;    // J (2D: J/m)
  double hourglass = 0.0;  // J (2D: J/m)
  KERF_FUNCTION double total() const { return elastic + hourglass; }
};

template <int D, class P>
KERF_FUNCTION SolidEnergy energy_of(const SolidView<D, P>& solid, Index i) {
  if (solid.detached[i]) return {};
  const auto& medium = solid.medium(i);
  return {double(medium.mass) / double(medium.density) * energy_density_now(solid, i),
          0.5 * double(solid.ends[i].hourglass) * misfit(solid, i)};
}

template <int D, class P>
struct PowerTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const {
    sum.value[0] += double(solid.viscous_power[i]);
  }
};

template <int D, class P>
struct EnergyTerms {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<2>& sum) const {
    const SolidEnergy energy = energy_of(solid, i);
    sum.value[0] += energy.elastic;
    sum.value[1] += energy.hourglass;
  }
};

}  // namespace kerf
