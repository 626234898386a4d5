// SPDX-License-Identifier: Apache-2.0
// BondForce computes the force on a particle from its bonds, which is minus the gradient of the
// stored energy
//   sum_i V_i psi(F_i) + 1/2 sum_i mu_i sum_j w_ij |gamma_ij|^2,   gamma_ij = F_i R - (x_j - x_i).
// Elastic part (Bonet & Lok 1999): sum_j w_ij (P_i B_i + P_j B_j) R. Hourglass part: the moment
// sum_j w_ij gamma_ij (x) R vanishes because F_i is the least-squares fit with these weights, so
// the derivative through F_i drops out (Silling, Comput. Methods Appl. Mech. Engrg. 322 (2017) 42)
// and the force is - sum_j w_ij [mu_i (F_i R - x_ij) + mu_j (F_j R - x_ij)]. Together
//   m_i a_i = sum_j w_ij [(A_i + A_j) R + (mu_i + mu_j) (u_j - u_i)],
// A of solid/deformation_gradient.hpp. It is equal and opposite on j: to the last bit, but for a
// bond between a particle that the SIMD kernel computes and one that the general loop computes,
// where it is to rounding.
#pragma once

#include "simd/run_in_blocks.hpp"
#include "solid/hourglass_viscosity.hpp"

namespace kerf {

// The viscosity of bonds (solid/bond_terms.hpp) between any two media.
template <int D, class P>
struct BondViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = true, in_simd = true;

  // Adds the force on i and half of the power that the pair dissipates.
  template <class End>
  KERF_FUNCTION void add(const SolidView<D, P>& solid, const ChosenBond<D, Real, End>& chosen,
                         Vector<D, Real>& force, Real& power) const {
    const auto& [i, j, bond] = chosen;
    add_bond_viscosity(force, power, bond, solid.velocity_bond(i, j),
                       Real(1) / norm(bond.reference), solid.viscosity_law(i, j.particle));
  }
};

template <int D, class P>
struct NoViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = false, in_simd = true;
};

// The viscosity of solids with plastic flow.
template <int D, class P>
struct FlowViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = true, in_simd = false;
  BondViscosity<D, P> bonds;
  HourglassViscosity<D, P> hourglass;

  template <class End>
  KERF_FUNCTION void add(const SolidView<D, P>& solid, const ChosenBond<D, Real, End>& chosen,
                         Vector<D, Real>& force, Real& power) const {
    bonds.add(solid, chosen, force, power);
    hourglass.add(solid, chosen, force, power);
  }
};

struct EveryBond {
  template <class End>
  KERF_FUNCTION bool operator()(Index, const End&) const {
    return true;
  }
};

// `Filter` chooses bonds, e.g. those across a plane; then(i) is called after each particle.
template <int D, class P, class Viscosity, class Filter, class Then>
struct BondForce {
  using Real = typename P::Real;
  using Force = BondForceSum<D, Real>;
  SolidView<D, P> solid;
  Viscosity viscosity;
  Filter filter;
  Then then;
  BlockResults<Force> known_sums{};  // of particles that the SIMD kernels compute

  KERF_FUNCTION void take(const BlockResults<Force>& sums) { known_sums = sums; }

  KERF_FUNCTION void operator()(Index i) const {
    set(i);
    then(i);
  }

 private:
  KERF_FUNCTION void set(Index i) const {
    if (solid.has_mirrors()) solid.mirror_acceleration[i] = Vector<D, Real>::zero();
    Force sum{Vector<D, Real>::zero(), Real(0)};
    if (solid.asleep[i]) {
      // Nothing acts on it.
    } else if (known_sums.are_known() && !solid.several_bodies[i]) {
      if (!solid.detached[i]) sum = known_sums[i];
    } else {
      sum = sum_all(i);
    }
    solid.acceleration[i] = (Real(1) / solid.medium(i).mass) * sum.force;
    solid.viscous_power[i] = sum.power;
  }

  KERF_NOINLINE KERF_FUNCTION Force sum_all(Index i) const {
    const Index end = solid.bonds.last(i), images = solid.first_image(i);
    Force sum = sum_bonds<DirectEnd>(i, solid.bonds.first(i), images);
    if (solid.has_mirrors()) {
      const Force mirrored = sum_bonds<BondEnd>(i, images, end);
      solid.mirror_acceleration[i] = (Real(1) / solid.medium(i).mass) * mirrored.force;
      sum.force += mirrored.force;
      sum.power += mirrored.power;
    }
    return sum;
  }

  // Returns the sum over bonds k of particle i.
  template <class End>
  KERF_FUNCTION Force sum_bonds(Index i, Index k, Index end) const {
    Force sum{Vector<D, Real>::zero(), Real(0)};
    const auto& own = solid.ends[i];
    const Matrix<D, Real> traction = own.traction;
    for (; k < end; ++k) {
      if (!solid.is_intact(i, k)) continue;
      const End j = solid.template bond_end<End>(i, k);
      if (!filter(i, j)) continue;
      const auto& other = solid.ends[j.particle];
      const ChosenBond<D, Real, End> chosen{i, j, solid.bond_geometry(i, k, j)};
      add_bond_force(sum.force, chosen.bond, traction + solid.image(j, other.traction),
                     own.hourglass + other.hourglass);
      if constexpr (Viscosity::acts) viscosity.add(solid, chosen, sum.force, sum.power);
    }
    return sum;
  }
};

}  // namespace kerf
