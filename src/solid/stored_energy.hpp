// SPDX-License-Identifier: Apache-2.0
// The energy that the solid stores, per particle: V psi(F), and the potential of the hourglass
// control 1/2 mu_i sum_j w_ij |F_i R - x_ij|^2, of which the force is the exact slope. In double,
// so that the difference of two totals has digits left.
#pragma once

#include "exec/ordered_sum.hpp"
#include "materials/elastic_law.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

template <int D, class P>
struct StoreEnergy {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.elastic_energy[i] = solid.hourglass_energy[i] = 0.0;
    if (solid.loose[i]) return;
    const auto medium = SolidMedium<double>::from(solid.medium(i));
    Matrix<D, double> h;
    for (int k = 0; k < D * D; ++k) h.component[k] = solid.gradient[i].component[k];
    solid.elastic_energy[i] = medium.volume() * energy_density(medium, green_strain(h));
    double sum = 0.0;
    for (Index k = solid.bond_begin[i]; k < solid.bond_begin[i + 1]; ++k) {
      const Index j = solid.neighbour[k];
      // gamma = F R - x = H R - u
      auto gamma = h * Vector<D, double>::from(solid.reference[j] - solid.reference[i]);
      gamma -= solid.displacement[j] - solid.displacement[i];
      sum += solid.weight[k] * dot(gamma, gamma);
    }
    solid.hourglass_energy[i] = 0.5 * medium.hourglass_modulus() * sum;
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
