// SPDX-License-Identifier: Apache-2.0
// The energy that the solid stores, per particle: V psi(F), and the potential of the hourglass
// control 1/2 mu_i sum_j w_ij |F_i R - x_ij|^2, of which the force is the exact slope. In double,
// so that the difference of two totals has digits left.
#pragma once

#include "exec/ordered_sum.hpp"
#include "solid/respond.hpp"

namespace kerf {

// sum_j w_ij |F_i R - x_ij|^2
template <int D, class P>
KERF_FUNCTION double misfit(const SolidView<D, P>& solid, Index i) {
  const auto h = Matrix<D, double>::from(solid.gradient[i]);
  double sum = 0.0;
  for (Index k = solid.bond_begin[i]; k < solid.bond_begin[i + 1]; ++k) {
    const BondEnd j = solid.bond_end(k);
    auto gamma = h * solid.template reference_bond<double>(i, j);  // H R - u
    gamma -= solid.template displacement_bond<double>(i, j);
    sum += double(solid.weight[k]) * dot(gamma, gamma);
  }
  return sum;
}

template <int D, class P>
struct StoreEnergy {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.elastic_energy[i] = solid.hourglass_energy[i] = 0.0;
    if (solid.loose[i]) return;
    const auto& medium = solid.medium(i);
    solid.elastic_energy[i] =
        double(medium.mass) / double(medium.density) * energy_density_now(solid, i);
    solid.hourglass_energy[i] = 0.5 * double(solid.hourglass[i]) * misfit(solid, i);
  }
};

// Sums of a solid, in a fixed order.
struct SolidEnergy {
  double elastic = 0.0;    // J (2D: J/m)
  double hourglass = 0.0;  // J (2D: J/m)
  double total() const { return elastic + hourglass; }
};

template <int D, class P>
struct PowerTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const {
    sum.value[0] += double(solid.viscous_power[i]);
  }
};

// Of the accelerations that are in force.
template <int D, class P>
struct ElasticPowerTerm {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  const Vector<D, Real>* velocity;

  KERF_FUNCTION void add(Index i, Terms<1>& sum) const {
    const auto acceleration = Vector<D, double>::from(solid.acceleration[i]);
    sum.value[0] +=
        double(solid.medium(i).mass) * dot(acceleration, Vector<D, double>::from(velocity[i]));
  }
};

template <int D, class P>
struct EnergyTerms {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<2>& sum) const {
    sum.value[0] += solid.elastic_energy[i];
    sum.value[1] += solid.hourglass_energy[i];
  }
};

}  // namespace kerf
