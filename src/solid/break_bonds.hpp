// SPDX-License-Identifier: Apache-2.0
// Breaks bonds by the criterion of their media: first a look that changes nothing and marks the
// particles concerned, then the break. Both ends of a bond come to the same answer by themselves.
#pragma once

#include "exec/ordered_sum.hpp"
#include "fracture/bond_criterion.hpp"
#include "fracture/crushing.hpp"
#include "fracture/severed.hpp"
#include "solid/break_account.hpp"

namespace kerf {

// Stands among the numbers that criteria prepare for one that is too low to pass, and was not
// worked out.
template <class T>
inline constexpr T too_low = T(-1e30);

template <int D, class P>
struct PrepareCriterion {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = solid.medium(i);
    solid.strained[i] = 0;
    if (solid.loose[i]) {
      solid.criterion[i] = Real(0);
      return;
    }
    const Real value = has_failed(i) || is_crushed(medium, solid.gradient[i]) ? crushed<Real>
                                                                              : prepared(i, medium);
    solid.criterion[i] = value;
    // A bond breaks by its own stretch, or where the mean of its ends passes, which one of them
    // then does; by a misfit where bonds are broken.
    const BondStrain<Real> stretch{Real(0), solid.stretch[i], Real(0)};
    solid.strained[i] = solid.mixed[i] || solid.torn[i] || !(value < crushed<Real>) ||
                        place_passes(value, medium) || bond_breaks(stretch, medium);
  }

 private:
  KERF_FUNCTION Real prepared(Index i, const SolidMedium<Real>& medium) const {
    const auto green = green_strain(solid.gradient[i]);
    if (medium.criterion == BondCriterion::crack_band)
      return solid.softens(i) ? solid.strain_now[i] : tensile_strain(medium, solid.gradient[i]);
    if (medium.criterion == BondCriterion::principal_stress && solid.flows(i))
      return std::sqrt(Real(1) + volume_square_less_one(green)) *
             PrincipalStress::largest(cauchy_now(solid, i));
    if (place_stays_below(medium, green)) return too_low<Real>;
    return prepare_criterion(medium, green, solid.damage(i));
  }
  // By ductile damage.
  KERF_FUNCTION bool has_failed(Index i) const {
    return solid.flows(i) && !(solid.flow_now[i].damage < Real(1));
  }
};

template <int D, class P>
struct BondTest {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION bool breaks(Index i, Index k, const SymmetricTensor<D, Real>& green) const {
    if (!solid.is_whole(i, k)) return false;
    const BondEnd end = solid.bond_end(i, k);
    return end.mirror == 0 ? passes(i, DirectEnd{end.particle}, green) : passes(i, end, green);
  }

 private:
  template <class End>
  KERF_FUNCTION bool passes(Index i, const End& j, const SymmetricTensor<D, Real>& green) const {
    const auto bond = solid.reference_bond(i, j);
    const auto change = solid.displacement_bond(i, j);
    const Real square = dot(bond, bond);
    const auto& a = solid.medium(i);
    const auto& b = solid.medium(j.particle);
    if (solid.torn[i] || solid.torn[j.particle]) {
      const Real misfit = misfit_squared(i, j, bond, change);
      if (is_severed(misfit, square, a) || is_severed(misfit, square, b)) return true;
    }
    BondStrain<Real> strain;
    // |x|^2 - R^2 = (2 R + u) . u
    strain.own = dot(Real(2) * bond + change, change) / square;
    if (!(strain.own > Real(0))) return false;  // no bond breaks that is not stretched
    const bool same = solid.medium_index[i] == solid.medium_index[j.particle];
    strain.prepared = Real(0.5) * (criterion_of(i) + criterion_of(j.particle));
    if (place_passes(strain.prepared, a) || (!same && place_passes(strain.prepared, b)))
      strain.mean =
          dot(bond, (green + green_strain(solid.seen(j, solid.gradient[j.particle]))) * bond) /
          square;
    return bond_breaks(strain, a) || (!same && bond_breaks(strain, b));
  }

  KERF_FUNCTION Real criterion_of(Index i) const {
    const Real known = solid.criterion[i];
    return known > too_low<Real>
               ? known
               : prepare_criterion(solid.medium(i), green_strain(solid.gradient[i]),
                                   solid.damage(i));
  }

  template <class End>
  KERF_FUNCTION Real misfit_squared(Index i, const End& j, const Vector<D, Real>& bond,
                                    const Vector<D, Real>& change) const {
    const auto fitted =
        Real(0.5) * ((solid.gradient[i] + solid.seen(j, solid.gradient[j.particle])) * bond);
    return dot(fitted - change, fitted - change);
  }
};

// Of every bond that breaks at least one end is `strained`; it marks both.
template <int D, class P>
struct MarkBreaking {
  using Real = typename P::Real;
  BondTest<D, P> test;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& solid = test.solid;
    if (!solid.strained[i]) return;
    if (!(solid.criterion[i] < crushed<Real>)) mark(i);
    const auto green = green_strain(solid.gradient[i]);
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k)
      if (test.breaks(i, k, green)) {
        mark(i);
        mark(solid.bond_end(i, k).particle);
      }
  }

 private:
  // By several at once, all with the same value.
  KERF_FUNCTION void mark(Index i) const {
#if defined(__CUDA_ARCH__)
    test.solid.changed[i] = 1;
#else
    __atomic_store_n(&test.solid.changed[i], std::uint8_t(1), __ATOMIC_RELAXED);
#endif
  }
};

template <int D, class P>
struct BreakMarked {
  using Real = typename P::Real;
  BondTest<D, P> test;
  BreakAccounts<D, P> accounts;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& solid = test.solid;
    if (!solid.changed[i]) return;
    accounts.open(solid, i);
    if (!(solid.criterion[i] < crushed<Real>)) {  // or failed
      solid.loose[i] = 1;
      return;
    }
    const auto green = green_strain(solid.gradient[i]);
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k)
      if (test.breaks(i, k, green)) solid.break_bond(i, k);
  }
};

// Looks once more after a break: the fit over the bonds that are left may find a particle crushed.
template <int D, class P>
struct Crush {
  SolidView<D, P> solid;
  BreakAccounts<D, P> accounts;

  KERF_FUNCTION void operator()(Index i) const {
    if (!accounts.of[i].is_open || solid.loose[i] ||
        !is_crushed(solid.medium(i), solid.gradient[i]))
      return;
    solid.loose[i] = 1;
    solid.changed[i] = 1;
  }
};

// Breaks the bonds between places that are apart from the start, as on the two sides of a notch:
// `separates(X_i, X_j)`, the same in both directions.
template <int D, class P, class Separates>
struct CutBonds {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  Separates separates;

  KERF_FUNCTION void operator()(Index i) const {
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      const BondEnd j = solid.bond_end(i, k);
      const auto place = solid.bonds.mirrors.image_place(j.mirror, solid.reference[j.particle]);
      if (!separates(solid.reference[i], place)) continue;
      solid.break_bond(i, k);
      solid.changed[i] = 1;
    }
  }
};

// Intact bonds, each counted from both ends, and loose particles.
template <int D, class P>
struct CountTerms {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void add(Index i, Terms<2>& sum) const {
    sum.value[0] += solid.whole_bonds(i);
    sum.value[1] += solid.loose[i];
  }
};

}  // namespace kerf
