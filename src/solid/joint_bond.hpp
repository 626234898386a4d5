// SPDX-License-Identifier: Apache-2.0
// JointEnd judges a bond between two solids of unlike stiffness, as where bodies are joined. The
// bond is stretched as two springs in series are: of its strain e the end a has
//   e_a = 2 M_b / (M_a + M_b) e,   M = (1 - D) (K + 4 G / 3),
// nearly nothing where it is the stiffer one. Each end compares its own part with its own limits.
// The gradients of the particles beside a joint miss theirs, the stiffer one upwards and the softer
// one downwards, so that what is compared with the criterion of an end is the mean over both ends
// of the stress, or of the stress as a strain of this end.
#pragma once

#include "fracture/unstretched_failure.hpp"
#include "solid/criterion_particle.hpp"

namespace kerf {

// Whether two solids differ in stiffness, so that a bond between them is stretched unevenly.
template <class T>
KERF_FUNCTION bool have_unlike_stiffness(const ElasticModuli<T>& a, const ElasticModuli<T>& b) {
  return a.bulk_modulus != b.bulk_modulus || a.shear_modulus != b.shear_modulus;
}

// One end of such a bond: particle i, a solid `of_i`.
template <int D, class P>
struct JointEnd {
  using Real = typename P::Real;
  const SolidView<D, P>& solid;
  Index i, j;
  const BondedSolid<Real>&of_i, &of_j;

  // M_j / M_i.
  KERF_FUNCTION Real ratio() const { return stiffness(j) / stiffness(i); }
  // e_i / e.
  KERF_FUNCTION Real share() const {
    const Real unlike = ratio();
    return Real(2) * unlike / (Real(1) + unlike);
  }
  // Returns whether the bond breaks by the limits of this end; `strain` is without the number of
  // the criterion.
  KERF_FUNCTION bool breaks(const BondStrain<Real>& strain) const {
    if (!of_i.bonds_can_break()) return false;
    BondStrain<Real> part = strain;
    part.own *= share();
    part.mean *= share();
    part.prepared = too_low<Real>;
    if (bond_breaks(part, of_i)) return true;
    if (!part.is_opening()) return false;
    part.prepared = prepared();
    return bond_breaks(part, of_i);
  }
  // The same by its misfit (fracture/unstretched_failure.hpp).
  KERF_FUNCTION bool fails(Real misfit_squared, Real length_squared) const {
    return fails_by_misfit(share() * share() * misfit_squared, length_squared, of_i);
  }

 private:
  KERF_FUNCTION Real stiffness(Index at) const {
    const auto& medium = solid.medium(at);
    const Real modulus = medium.bulk_modulus + Real(4.0 / 3.0) * medium.shear_modulus;
    return solid.softens(at) ? modulus * remaining(at) : modulus;
  }
  // Returns 1 - D, by the limits of a slow test and k / R, at least what the ratio of two of them
  // needs to be finite.
  KERF_FUNCTION Real remaining(Index at) const {
    const Real left = undamaged_share<Real>(solid.medium(at), solid.softening_strain(at));
    constexpr Real least = Real(1e-6);
    return left > least ? left : least;
  }
  // Returns the number that the criterion of i gives the mean of both ends.
  KERF_FUNCTION Real prepared() const {
    const Real here = criterion_of(solid, i);
    const AcrossJoint across = across_joint(of_i);
    if (across == AcrossJoint::end) return here;
    const BondedSolid<Real> there = of_j.with_criterion_of(of_i);
    const Real other = prepare_criterion(there, CriterionParticle<D, P>(solid, j, there));
    return Real(0.5) * (here + (across == AcrossJoint::stress ? other : ratio() * other));
  }
};

}  // namespace kerf
