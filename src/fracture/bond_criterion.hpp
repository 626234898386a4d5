// SPDX-License-Identifier: Apache-2.0
// The fracture criteria of bonds. A medium chooses one by the word of the case file. Each has (see
// also core/law_list.hpp)
//   keys                    the other keys of a material that it needs and excludes (CriterionKeys)
//   limits(input)           the strains at which a material begins to fail and has failed
//   can_break(has_limit)    whether it ever breaks a bond; has_limit: the material has a failure
//                           strain or a fracture energy
//   prepare(particle)       a number per particle; a bond gets the mean of its ends. It may take
//                           solid, green, damage, largest_stress() and tensile_strain()
//   passes(prepared, solid) whether this number requires the tensors along the bond
//   breaks(bond, solid)     whether a bond of this solid breaks (bond_strain.hpp)
// and may have
//   stays_below(solid, green)   whether a cheap bound shows that prepare() does not pass
//   strengthen(factor)          multiplies its own limits, those beside the strains of the solid
//   across_joint                what it compares of a bond to a solid of another stiffness; strain
//   softens                     whether its stress softens, and a compressive_strength counts
//   tensile_limit(solid)        the strain of a tensile test at which it begins to break bonds,
//                               where that is not a strain of the solid
// A criterion gets the same numbers of a bond from either end, so that both ends reach the same
// decision.
#pragma once

#include "fracture/bond_strain.hpp"
#include "fracture/brittle_band.hpp"
#include "fracture/compressive_strength.hpp"
#include "fracture/crack_band_criterion.hpp"
#include "fracture/criteria.hpp"
#include "fracture/equivalent_total_strain.hpp"
#include "fracture/grady_kipp.hpp"
#include "fracture/principal_strain.hpp"
#include "fracture/principal_stress.hpp"
#include "fracture/strain_energy.hpp"
#include "fracture/strength_rate.hpp"

namespace kerf {

KERF_DEFINE_LAW_SET(BondCriterionSet, BondCriterion, KERF_BOND_CRITERIA)

// Whether a criterion ever breaks a bond; `has_limit`: a failure strain or fracture energy is
// given.
template <class T>
KERF_FUNCTION bool can_break_bonds(const BondCriterionSet<T>& criteria, BondCriterion criterion,
                                   bool has_limit) {
  return BondCriterionSet<T>::visit(
      criteria, criterion, [&](const auto& chosen) { return chosen.can_break(has_limit); });
}

template <class T>
struct Strengthen {
  T factor;
  template <class Law>
  KERF_FUNCTION void operator()(Law& law) const {
    if constexpr (requires { law.strengthen(factor); }) law.strengthen(factor);
  }
};
template <class T>
struct TensileLimit {
  const BreakableSolid<T>& solid;
  template <class Law>
  KERF_FUNCTION T operator()(const Law& law) const {
    if constexpr (requires { law.tensile_limit(solid); })
      return law.tensile_limit(solid);
    else
      return solid.softens() ? solid.softening_strain : solid.failure_strain;
  }
};

// A solid whose bonds may break.
template <class T>
struct BondedSolid : BreakableSolid<T>, BondCriterionSet<T> {
  BondCriterion criterion = BondCriterion::principal_strain;
  StrengthRate<T> strength_rate;

  KERF_FUNCTION bool bonds_can_break() const {
    return can_break_bonds(*this, criterion, this->failure_strain > T(0));
  }
  KERF_FUNCTION bool depends_on_rate() const { return strength_rate.is_on() && bonds_can_break(); }

  // e_0, the strain of a slow tensile test at which it begins to fail.
  KERF_FUNCTION T slow_failure_strain() const {
    return BondCriterionSet<T>::visit(*this, criterion, TensileLimit<T>{*this});
  }
  // The solid with its limits of strain and stress multiplied.
  KERF_FUNCTION BondedSolid strengthened(T factor) const {
    BondedSolid solid = *this;
    solid.failure_strain *= factor;
    solid.softening_strain *= factor;
    BondCriterionSet<T>::visit(solid, criterion, Strengthen<T>{factor});
    return solid;
  }

  // This solid with the fracture criterion and the limits of another one.
  KERF_FUNCTION BondedSolid with_criterion_of(const BondedSolid& other) const {
    BondedSolid solid = *this;
    static_cast<BondCriterionSet<T>&>(solid) = other;
    solid.criterion = other.criterion;
    solid.failure_strain = other.failure_strain;
    solid.softening_strain = other.softening_strain;
    return solid;
  }

  template <class Other>
  KERF_FUNCTION static BondedSolid from(const BondedSolid<Other>& other) {
    BondedSolid solid;
    static_cast<BreakableSolid<T>&>(solid) = BreakableSolid<T>::from(other);
    static_cast<BondCriterionSet<T>&>(solid) = BondCriterionSet<T>::from(other);
    solid.criterion = other.criterion;
    solid.strength_rate = StrengthRate<T>::from(other.strength_rate);
    return solid;
  }
};

// The number of the criterion for a particle, whose `solid` is a BondedSolid.
template <class T, class Particle>
KERF_FUNCTION T prepare_criterion(const BondedSolid<T>& solid, const Particle& particle) {
  return BondCriterionSet<T>::visit(
      solid, solid.criterion, [&](const auto& chosen) { return T(chosen.prepare(particle)); });
}

struct AcrossJointOf {
  template <class Law>
  KERF_FUNCTION AcrossJoint operator()(const Law&) const {
    if constexpr (requires { Law::across_joint; })
      return Law::across_joint;
    else
      return AcrossJoint::strain;
  }
};
template <class T>
KERF_FUNCTION AcrossJoint across_joint(const BondedSolid<T>& solid) {
  return BondCriterionSet<T>::visit(solid, solid.criterion, AcrossJointOf{});
}

template <int D, class T>
struct StaysBelow {
  const BreakableSolid<T>& solid;
  const SymmetricTensor<D, T>& green;
  template <class Law>
  KERF_FUNCTION bool operator()(const Law& law) const {
    if constexpr (requires { law.stays_below(solid, green); })
      return law.stays_below(solid, green);
    else
      return false;
  }
};
// Whether a cheap bound shows that the number of prepare_criterion() does not pass.
template <int D, class T>
KERF_FUNCTION bool stays_below_limit(const BondedSolid<T>& solid,
                                     const SymmetricTensor<D, T>& green) {
  return BondCriterionSet<T>::visit(solid, solid.criterion, StaysBelow<D, T>{solid, green});
}

template <class T>
KERF_FUNCTION bool criterion_passes(T prepared, const BondedSolid<T>& solid) {
  return BondCriterionSet<T>::visit(
      solid, solid.criterion, [&](const auto& chosen) { return chosen.passes(prepared, solid); });
}

template <class T>
KERF_FUNCTION bool bond_breaks(const BondStrain<T>& bond, const BondedSolid<T>& solid) {
  return BondCriterionSet<T>::visit(solid, solid.criterion,
                                    [&](const auto& chosen) { return chosen.breaks(bond, solid); });
}

}  // namespace kerf
