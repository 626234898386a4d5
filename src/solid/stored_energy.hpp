// SPDX-License-Identifier: Apache-2.0
// energy_of() computes the energy that a particle of the solid stores: s V psi(F), and the
// potential of the hourglass control 1/2 mu_i sum_j w_ij |F_i R - x_ij|^2, of which the force is
// minus the exact gradient. The share s is that of solid/limit_break_energy.hpp. It is in double,
// so that the difference of two totals keeps enough digits; the sums over bonds of the total of a
// solid are those of the SIMD kernels.
#pragma once

#include "parallel/ordered_sum.hpp"
#include "simd/run_in_blocks.hpp"
#include "solid/simd/packed_bonds.hpp"
#include "solid/stress_response.hpp"

namespace kerf {

// Returns u_j - u_i a time `ago`, s, at the present velocities, m.
template <int D, class P>
KERF_FUNCTION Vector<D, double> earlier_displacement_bond(const SolidView<D, P>& solid, Index i,
                                                          const BondEnd& j, double ago) {
  auto change = solid.template displacement_bond<double>(i, j);
  if (ago != 0.0) change -= ago * Vector<D, double>::from(solid.velocity_bond(i, j));
  return change;
}

// Returns the displacement gradient H over the intact bonds a time `ago`, s.
template <int D, class P>
KERF_FUNCTION Matrix<D, double> earlier_gradient(const SolidView<D, P>& solid, Index i,
                                                 double ago) {
  auto sum = Matrix<D, double>::zero();
  for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
    if (!solid.is_intact(i, k)) continue;
    const BondEnd j = solid.bond_end(i, k);
    const double weight = solid.weight(i, k, j, solid.reference_bond(i, j));
    add_outer(sum, earlier_displacement_bond(solid, i, j, ago),
              weight * solid.template reference_bond<double>(i, j));
  }
  return sum * solid.correction[i].matrix();
}

// Returns sum_j w_ij |F_i R - x_ij|^2 at the gradient H = F - 1 a time `ago`, s.
template <int D, class P>
KERF_FUNCTION double misfit(const SolidView<D, P>& solid, Index i, const Matrix<D, double>& h,
                            double ago = 0.0) {
  double sum = 0.0;
  for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
    if (!solid.is_intact(i, k)) continue;
    const BondEnd j = solid.bond_end(i, k);
    auto gamma = h * solid.template reference_bond<double>(i, j);  // H R - u
    gamma -= earlier_displacement_bond(solid, i, j, ago);
    sum += double(solid.weight(i, k, j, solid.reference_bond(i, j))) * dot(gamma, gamma);
  }
  return sum;
}
template <int D, class P>
KERF_FUNCTION double misfit(const SolidView<D, P>& solid, Index i) {
  return misfit(solid, i, Matrix<D, double>::from(solid.gradient[i]));
}

// The stored energy of one particle, or of all.
struct SolidEnergy {
  double elastic = 0.0;    // J (2D: J/m)
  double hourglass = 0.0;  // J (2D: J/m)
  KERF_FUNCTION double total() const { return elastic + hourglass; }
  static SolidEnergy of(const Terms<2>& sum) { return {sum.value[0], sum.value[1]}; }
};

// Return the two parts, J, of particle i, which is not detached: at the gradient H in the state
// given, and with a `misfit`, J/Pa.
template <int D, class P>
KERF_FUNCTION double elastic_energy_of(const SolidView<D, P>& solid, Index i,
                                       const Matrix<D, double>& h, const EnergyState<D, P>& state) {
  const auto& medium = solid.medium(i);
  return double(medium.mass) / double(medium.density) * energy_density_at(solid, i, h, state);
}
template <int D, class P>
KERF_FUNCTION double hourglass_energy_of(const SolidView<D, P>& solid, Index i, double misfit) {
  return 0.5 * double(solid.ends[i].hourglass) * misfit;
}

// Returns the energy of particle i at the gradient H a time `ago`, s, in the state given.
template <int D, class P>
KERF_FUNCTION SolidEnergy energy_of(const SolidView<D, P>& solid, Index i,
                                    const Matrix<D, double>& h, const EnergyState<D, P>& state,
                                    double ago = 0.0) {
  if (solid.detached[i]) return {};
  return {elastic_energy_of(solid, i, h, state),
          hourglass_energy_of(solid, i, misfit(solid, i, h, ago))};
}
// Returns its energy at the current deformation.
template <int D, class P>
KERF_FUNCTION SolidEnergy energy_of(const SolidView<D, P>& solid, Index i) {
  return energy_of(solid, i, Matrix<D, double>::from(solid.gradient[i]),
                   EnergyState<D, P>::now(solid, i));
}

template <int D, class P>
struct PowerTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const {
    sum.value[0] += double(solid.viscous_power[i]);
  }
};

// Keeps the misfit of each particle, by the SIMD kernel where that computes it.
template <int D, class P>
struct KeepMisfit {
  using Real = typename P::Real;
  using Sum = BondMisfitSum<D, Real>;
  SolidView<D, P> solid;
  Real* of;
  const std::uint8_t* left_out = nullptr;  // 1 for particles without a misfit; null: of none
  BlockResults<Sum> known_sums{};

  KERF_FUNCTION void take(const BlockResults<Sum>& sums) { known_sums = sums; }
  KERF_FUNCTION void operator()(Index i) const {
    if (left_out != nullptr && left_out[i]) return;
    if (solid.detached[i] || solid.asleep[i])
      of[i] = Real(0);
    else if (known_sums.are_known() && !solid.several_bodies[i])
      of[i] = known_sums[i].misfit;
    else
      of[i] = static_cast<Real>(misfit(solid, i));
  }
};

template <int D, class P>
struct EnergyTerms {
  SolidView<D, P> solid;
  const typename P::Real* misfit_of;
  KERF_FUNCTION void add(Index i, Terms<2>& sum) const {
    if (solid.detached[i] || solid.asleep[i]) return;
    sum.value[0] += elastic_energy_of(solid, i, Matrix<D, double>::from(solid.gradient[i]),
                                      EnergyState<D, P>::now(solid, i));
    sum.value[1] += hourglass_energy_of(solid, i, double(misfit_of[i]));
  }
};

}  // namespace kerf
