// SPDX-License-Identifier: Apache-2.0
// The list of the fracture criteria of bonds: LAW(word, Class), with the word of the case file and
// the class template that holds the parameters. The classes are included in bond_criterion.hpp,
// which lists the members of each.
#pragma once

#include "core/law_list.hpp"

#define KERF_BOND_CRITERIA(LAW)                 \
  LAW(principal_strain, PrincipalStrain)        \
  LAW(equivalent_strain, EquivalentTotalStrain) \
  LAW(principal_stress, PrincipalStress)        \
  LAW(strain_energy, StrainEnergy)              \
  LAW(crack_band, CrackBandStrain)              \
  LAW(brittle_band, BrittleBand)                \
  LAW(grady_kipp, GradyKipp)

namespace kerf {

KERF_DEFINE_LAW_ENUM(BondCriterion, bond_criterion_words, KERF_BOND_CRITERIA)

}  // namespace kerf
