// SPDX-License-Identifier: Apache-2.0
// The fracture criteria of bonds, chosen per medium while the program runs.
#pragma once

#include "fracture/crack_band_strain.hpp"
#include "fracture/damaged_bond.hpp"
#include "fracture/equivalent_total_strain.hpp"
#include "fracture/principal_strain.hpp"
#include "fracture/principal_stress.hpp"
#include "fracture/strain_energy.hpp"

namespace kerf {

// `damage`: of the criterion grady_kipp.
template <int D, class T>
KERF_FUNCTION T prepare_criterion(const SolidMedium<T>& solid, const SymmetricTensor<D, T>& green,
                                  T damage = T(0)) {
  switch (solid.criterion) {
    case BondCriterion::principal_strain:
      return PrincipalStrain::prepare(solid, green);
    case BondCriterion::equivalent_strain:
      return EquivalentTotalStrain::prepare(solid, green);
    case BondCriterion::principal_stress:
      return PrincipalStress::prepare(solid, green);
    case BondCriterion::strain_energy:
      return StrainEnergy::prepare(solid, green);
    case BondCriterion::crack_band:  // by what the place remembers (break_bonds.hpp)
      break;
    case BondCriterion::grady_kipp:
      return DamagedBond::prepare(damage);
  }
  return T(0);
}

// Whether a look shows that what prepare_criterion() would say does not pass.
template <int D, class T>
KERF_FUNCTION bool place_stays_below(const SolidMedium<T>& solid,
                                     const SymmetricTensor<D, T>& green) {
  return solid.criterion == BondCriterion::principal_strain &&
         PrincipalStrain::stays_below(solid, green);
}

template <class T>
KERF_FUNCTION bool place_passes(T prepared, const SolidMedium<T>& solid) {
  switch (solid.criterion) {
    case BondCriterion::principal_strain:
      return PrincipalStrain::passes(prepared, solid);
    case BondCriterion::equivalent_strain:
      return EquivalentTotalStrain::passes(prepared, solid);
    case BondCriterion::principal_stress:
      return PrincipalStress::passes(prepared, solid);
    case BondCriterion::strain_energy:
      return StrainEnergy::passes(prepared, solid);
    case BondCriterion::crack_band:
      return CrackBandStrain::passes(prepared, solid);
    case BondCriterion::grady_kipp:
      return DamagedBond::passes(prepared);
  }
  return false;
}

template <class T>
KERF_FUNCTION bool bond_breaks(const BondStrain<T>& bond, const SolidMedium<T>& solid) {
  switch (solid.criterion) {
    case BondCriterion::principal_strain:
      return PrincipalStrain::breaks(bond, solid);
    case BondCriterion::equivalent_strain:
      return EquivalentTotalStrain::breaks(bond, solid);
    case BondCriterion::principal_stress:
      return PrincipalStress::breaks(bond, solid);
    case BondCriterion::strain_energy:
      return StrainEnergy::breaks(bond, solid);
    case BondCriterion::crack_band:
      return CrackBandStrain::breaks(bond, solid);
    case BondCriterion::grady_kipp:
      return DamagedBond::breaks(bond);
  }
  return false;
}

}  // namespace kerf
