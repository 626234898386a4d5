// SPDX-License-Identifier: Apache-2.0
// Correct computes the gradient correction of a particle when its bonds have changed:
//   B_i = (sum_j V_j f_ij (X_j - X_i) (x) grad_0 W_ij)^-1 = V_i (sum_j w_ij R (x) R)^-1,
// after which the gradient of any linear field is exact, beside free surfaces and cracks too (Bonet
// & Lok, Comput. Methods Appl. Mech. Engrg. 180 (1999) 97). A particle that has no valid B is
// detached.
// In single precision w R of the sum of H and mu w of the force are rounded apart, and the
// particles of a lattice round alike, so that hourglass control would turn a body that rotates.
// With
//   M = sum_j R (x) [w R],   N = sum_j [2 mu w] / (2 mu) R (x) R,
// brackets for what is rounded and mu of the intact medium, B_i = V_i M^-1 N M^-T makes the couple
// of a linear field vanish: that field has H = (its gradient) N M^-T.
#pragma once

#include "simd/run_in_blocks.hpp"
#include "solid/bond_break_energy.hpp"

namespace kerf {

// D bonds determine a deformation gradient, and then every motion is a deformation: noise cannot be
// distinguished from strain. With one more the hourglass control resists it.
template <int D>
inline constexpr Index least_bonds = D + 1;
// Least eigenvalue of the moment, which is near 1 inside, 0.4 on a face and 0.2 in the corner of a
// cube along the lattice; the corner of a square at 15 degrees to it, which holds, has 0.07.
inline constexpr double least_moment = 0.05;

template <int D, class P>
struct Correct {
  using Real = typename P::Real;
  using Moments = BondMoments<D, Real>;
  using Stored = StoredCorrection<D, Real>;
  SolidView<D, P> solid;
  BlockResults<Moments> known_moments{};  // of particles that the SIMD kernels compute

  KERF_FUNCTION void take(const BlockResults<Moments>& moments) { known_moments = moments; }

  KERF_FUNCTION void operator()(Index i) const {
    if (!solid.changed[i]) return;
    solid.changed[i] = 0;
    if (solid.detached[i]) return clear_correction(i);
    const bool is_known = known_moments.are_known() && !solid.several_bodies[i];
    const Moments moments = is_known ? known_moments[i] : sum_all(i);
    const double volume = solid.medium(i).reference_volume();
    const Index intact = solid.intact_bonds(i);
    solid.has_broken_bonds[i] = intact < solid.bonds.count[i];
    auto inverse = identity<D, double>();
    const auto moment = (1.0 / volume) * moments.of_gradient;
    if (intact < least_bonds<D> || !divide(inverse, moment, least_moment)) {
      solid.detached[i] = 1;
      return clear_correction(i);
    }
    solid.correction[i] = Stored::from((1.0 / (volume * volume)) *
                                       (inverse * moments.of_hourglass * transposed(inverse)));
  }

 private:
  KERF_FUNCTION void clear_correction(Index i) const {
    solid.correction[i] = Stored{};
    solid.changed[i] = solid.intact_bonds(i) > 0;
  }
  KERF_NOINLINE KERF_FUNCTION Moments sum_all(Index i) const {
    Moments moments{Matrix<D, double>::zero(), Matrix<D, double>::zero()};
    const Real hourglass = hourglass_of_pair(solid.medium(i));
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      if (!solid.is_intact(i, k)) continue;
      const BondEnd j = solid.bond_end(i, k);
      const Vector<D, Real> bond = solid.reference_bond(i, j);
      const Real weight = solid.weight(i, k, j, bond);
      add_bond_moments(moments, bond, weight * bond, weight * hourglass, hourglass);
    }
    return moments;
  }
};

// Prepares Correct: marks what it leaves out, and as having lost bonds what may have lost some.
template <int D, class P>
struct PrepareCorrection {
  SolidView<D, P> solid;
  std::uint8_t* left_out;

  KERF_FUNCTION void operator()(Index i) const {
    left_out[i] = solid.changed[i] ? 0 : 1;
    if (solid.changed[i]) solid.has_broken_bonds[i] = 1;
  }
};

// Breaks the bonds of `chosen` particles, on the side of this particle.
template <int D, class P>
struct BreakAllBonds {
  SolidView<D, P> solid;
  const std::uint8_t* chosen;  // 1: all its bonds break
  BreakRecords<D, P> records = {};

  KERF_FUNCTION void operator()(Index i) const {
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      if (!solid.is_intact(i, k)) continue;
      if (!chosen[i] && !chosen[solid.bond_end(i, k).particle]) continue;
      records.record(solid, i);
      solid.break_bond(i, k);
      solid.changed[i] = 1;
    }
  }
};

}  // namespace kerf
