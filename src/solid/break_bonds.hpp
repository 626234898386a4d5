// SPDX-License-Identifier: Apache-2.0
// These loops break bonds by the criterion of their media: first a test that changes nothing and
// marks the particles concerned, then the break. Both ends of a bond reach the same decision on
// their own.
#pragma once

#include "fracture/bond_criterion.hpp"
#include "fracture/unstretched_failure.hpp"
#include "parallel/ordered_sum.hpp"
#include "solid/bond_break_energy.hpp"
#include "solid/joint_bond.hpp"

namespace kerf {

// Whether a particle has bonds to media with other limits: such a bond may meet the limit of one
// end by the number of the other, which does not meet its own.
template <int D, class P>
KERF_FUNCTION bool has_other_limits(const SolidView<D, P>& solid, Index i) {
  return (solid.unlike_media[i] & unlike_media::limits) != 0;
}

template <int D, class P>
struct PrepareCriterion {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  Real* gradient_norm;  // out, |H| of each particle

  KERF_FUNCTION void operator()(Index i) const {
    Real square(0);
    for (const Real component : solid.gradient[i].component) square += component * component;
    gradient_norm[i] = std::sqrt(square);
    solid.strained[i] = 0;
    if (solid.detached[i]) {
      solid.criterion[i] = Real(0);
      return;
    }
    if (solid.asleep[i]) {
      solid.criterion[i] = too_low<Real>;
      return;
    }
    with_limits_at_rate(solid, i, Prepare{*this, i});
  }

 private:
  struct Prepare {
    const PrepareCriterion& loop;
    Index i;
    KERF_FUNCTION void operator()(const BondedSolid<Real>& limits) const {
      loop.prepare(i, limits);
    }
  };
  KERF_FUNCTION void prepare(Index i, const BondedSolid<Real>& limits) const {
    const Real value = has_failed(i) || fails_in_compression(limits, solid.gradient[i])
                           ? compressive_failure<Real>
                           : prepared(i, limits);
    solid.criterion[i] = value;
    // A bond breaks by its own stretch, or if the mean of its ends meets the criterion (then at
    // least one of the ends meets it, if their limits are the same), or by bond misfit failure
    // beside broken bonds.
    const BondStrain<Real> stretch{Real(0), solid.stretch[i], Real(0)};
    solid.strained[i] = has_other_limits(solid, i) || solid.has_broken_bonds[i] ||
                        !(value < compressive_failure<Real>) || criterion_passes(value, limits) ||
                        bond_breaks(stretch, limits);
  }
  KERF_FUNCTION Real prepared(Index i, const BondedSolid<Real>& limits) const {
    const CriterionParticle<D, P> particle(solid, i, limits);
    if (stays_below_limit(limits, particle.green)) return too_low<Real>;
    return prepare_criterion(limits, particle);
  }
  // Returns whether the particle has failed by ductile damage.
  KERF_FUNCTION bool has_failed(Index i) const {
    return solid.flows(i) && !solid.held[i] && !(solid.current_flow[i].damage < Real(1));
  }
};

template <int D, class P>
struct BondTest {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  const Real* gradient_norm;  // |H| of each particle

  // The bonds of a particle are stretched by lambda^2 - 1 <= `stretch`.
  struct LargestStretch {
    Real stretch, displacement;  // |u_j - u_i| <= |R| + |x_j - x_i| over |R|
  };
  KERF_FUNCTION LargestStretch largest_stretch(Index i) const {
    const Real rounding = Real(1e-5);
    const Real known = solid.stretch[i] > Real(0) ? solid.stretch[i] : Real(0);
    const Real stretch = known + rounding * (Real(1) + known);
    return {stretch, Real(1) + std::sqrt(Real(1) + stretch)};
  }
  // Whether bounds show that no bond of i to j breaks, without its own lengths:
  // |gamma_ij| <= (|H_i| + |H_j|) |R| / 2 + |u_j - u_i|.
  KERF_FUNCTION bool stays_intact(Index i, Index j, const LargestStretch& largest) const {
    if (solid.medium_index[i] != solid.medium_index[j]) return false;
    const auto& medium = solid.medium(i);
    const BondStrain<Real> strain{Real(0), largest.stretch, mean_criterion(i, j)};
    if (criterion_passes(strain.prepared, medium) || bond_breaks(strain, medium)) return false;
    if (!solid.has_broken_bonds[i] && !solid.has_broken_bonds[j]) return true;
    const Real misfit = Real(0.5) * (gradient_norm[i] + gradient_norm[j]) + largest.displacement;
    return !fails_by_misfit(misfit * misfit, Real(1), medium);
  }

  KERF_FUNCTION bool breaks(Index i, Index k, const SymmetricTensor<D, Real>& green) const {
    if (!solid.is_intact(i, k)) return false;
    const BondEnd end = solid.bond_end(i, k);
    if (solid.held[i] || solid.held[end.particle]) return false;
    return end.mirror == 0 ? passes(i, DirectEnd{end.particle}, green) : passes(i, end, green);
  }

 private:
  template <class End>
  KERF_FUNCTION bool passes(Index i, const End& j, const SymmetricTensor<D, Real>& green) const {
    const BondedSolid<Real>&a = solid.medium(i), &b = solid.medium(j.particle);
    const bool same = solid.medium_index[i] == solid.medium_index[j.particle];
    if (!solid.any_rate) return passes(i, j, green, {a, b, same});
    // Within a medium both ends have the mean of their factors.
    Real of_a = solid.strength_factor(i), of_b = solid.strength_factor(j.particle);
    if (same) of_a = of_b = Real(0.5) * (of_a + of_b);
    const auto strong_a = a.strengthened(of_a), strong_b = b.strengthened(of_b);
    return passes(i, j, green, {strong_a, strong_b, same});
  }

  // The solids of the two ends of a bond; `same`: of one medium.
  struct Ends {
    const BondedSolid<Real>&a, &b;
    bool same;
  };
  template <class End>
  KERF_FUNCTION bool passes(Index i, const End& j, const SymmetricTensor<D, Real>& green,
                            const Ends& of) const {
    const auto bond = solid.reference_bond(i, j);
    const auto change = solid.displacement_bond(i, j);
    const Real square = dot(bond, bond);
    const bool is_joint = !of.same && have_unlike_stiffness(of.a, of.b);
    const JointEnd<D, P> end_i{solid, i, j.particle, of.a, of.b},
        end_j{solid, j.particle, i, of.b, of.a};
    if (solid.has_broken_bonds[i] || solid.has_broken_bonds[j.particle]) {
      const Real misfit = misfit_squared(i, j, bond, change);
      const Real spacing = Real(0.5) * (solid.medium(i).spacing + solid.medium(j.particle).spacing);
      const bool fails =
          is_joint ? end_i.fails(misfit, square) || end_j.fails(misfit, square)
                   : fails_by_misfit(misfit, square, of.a) || fails_by_misfit(misfit, square, of.b);
      if (fails && !ends_press(square, square_growth(bond, change), spacing)) return true;
    }
    BondStrain<Real> strain;
    strain.own = square_growth(bond, change) / square;
    if (!(strain.own > Real(0))) return false;  // only stretched bonds break
    const auto sum = [&] {
      return green + green_strain(solid.image(j, solid.gradient[j.particle]));
    };
    if (is_joint) {
      strain.mean = dot(bond, sum() * bond) / square;
      return end_i.breaks(strain) || end_j.breaks(strain);
    }
    strain.prepared = mean_criterion(i, j.particle);
    if (criterion_passes(strain.prepared, of.a) ||
        (!of.same && criterion_passes(strain.prepared, of.b)))
      strain.mean = dot(bond, sum() * bond) / square;
    return bond_breaks(strain, of.a) || (!of.same && bond_breaks(strain, of.b));
  }

  KERF_FUNCTION Real mean_criterion(Index i, Index j) const {
    const bool both_low =
        !(solid.criterion[i] > too_low<Real>)&&!(solid.criterion[j] > too_low<Real>);
    if (both_low && !has_other_limits(solid, i)) return too_low<Real>;
    return Real(0.5) * (criterion_of(solid, i) + criterion_of(solid, j));
  }
  template <class End>
  KERF_FUNCTION Real misfit_squared(Index i, const End& j, const Vector<D, Real>& bond,
                                    const Vector<D, Real>& change) const {
    const auto fitted =
        Real(0.5) * ((solid.gradient[i] + solid.image(j, solid.gradient[j.particle])) * bond);
    return dot(fitted - change, fitted - change);
  }
};

// Marks both ends of every bond that breaks. At least one of them is `strained`.
template <int D, class P>
struct MarkBreaking {
  using Real = typename P::Real;
  BondTest<D, P> test;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& solid = test.solid;
    if (!solid.strained[i]) return;
    if (!(solid.criterion[i] < compressive_failure<Real>)) set_flag(solid.changed[i]);
    const auto green = green_strain(solid.gradient[i]);
    const auto largest = test.largest_stretch(i);
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      const Index j = solid.bond_end(i, k).particle;
      if (test.stays_intact(i, j, largest) || !test.breaks(i, k, green)) continue;
      set_flag(solid.changed[i]);
      set_flag(solid.changed[j]);
    }
  }
};

template <int D, class P>
struct BreakMarked {
  using Real = typename P::Real;
  BondTest<D, P> test;
  BreakRecords<D, P> records;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& solid = test.solid;
    if (!solid.changed[i]) return;
    records.record(solid, i);
    if (!(solid.criterion[i] < compressive_failure<Real>)) {  // or ductile failure
      solid.detached[i] = 1;
      return;
    }
    const auto green = green_strain(solid.gradient[i]);
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k)
      if (test.breaks(i, k, green)) solid.break_bond(i, k);
  }
};

// Breaks the bonds between positions that are separate from the start, as on the two sides of a
// notch: `separates(X_i, X_j)`, the same in both directions.
template <int D, class P, class Separates>
struct CutBonds {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  Separates separates;

  KERF_FUNCTION void operator()(Index i) const {
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      const BondEnd j = solid.bond_end(i, k);
      const auto other = solid.bonds.mirrors.image_position(j.mirror, solid.reference[j.particle]);
      if (!separates(solid.reference[i], other)) continue;
      solid.break_bond(i, k);
      solid.changed[i] = 1;
    }
  }
};

// Intact bonds, each counted from both ends, and detached particles.
template <int D, class P>
struct CountTerms {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void add(Index i, Terms<2>& sum) const {
    sum.value[0] += solid.intact_bonds(i);
    sum.value[1] += solid.detached[i];
  }
};

}  // namespace kerf
