// SPDX-License-Identifier: Apache-2.0
// The lists of the elastic laws, plastic laws and equations of state: LAW(word, Class), with the
// word of the case file and the class template that holds the parameters (core/law_list.hpp lists
// what each has). The class is included where the laws of its kind are evaluated: elastic_law.hpp,
// plastic_law.hpp, equation_of_state.hpp.
#pragma once

#include "core/law_list.hpp"

#define KERF_ELASTIC_LAWS(LAW) \
  LAW(neo_hookean, NeoHookean) \
  LAW(ogden, Ogden)            \
  LAW(st_venant_kirchhoff, StVenantKirchhoff)

#define KERF_PLASTIC_LAWS(LAW)           \
  LAW(none, NoPlasticity)                \
  LAW(von_mises, J2Hardening)            \
  LAW(johnson_cook, JohnsonCookStrength) \
  LAW(drucker_prager, DruckerPrager)

#define KERF_EQUATIONS_OF_STATE(LAW) \
  LAW(tait, Tait)                    \
  LAW(shock_hugoniot, ShockHugoniot)

namespace kerf {

KERF_DEFINE_LAW_ENUM(ElasticLaw, elastic_law_words, KERF_ELASTIC_LAWS)
KERF_DEFINE_LAW_ENUM(PlasticLaw, plastic_law_words, KERF_PLASTIC_LAWS)
KERF_DEFINE_LAW_ENUM(EquationOfState, equation_of_state_words, KERF_EQUATIONS_OF_STATE)

}  // namespace kerf
