// SPDX-License-Identifier: Apache-2.0
// Defines the walks of one instruction set, whose name KERF_LANES is.
#pragma once

#include "lanes/bond_walk.hpp"
#include "lanes/fluid_walk.hpp"
#include "lanes/search.hpp"
#include "lanes/walks.hpp"

#define KERF_LANES_TABLE_OF(name) name##_walks
#define KERF_LANES_TABLE(name) KERF_LANES_TABLE_OF(name)
#define KERF_LANES_TEXT_OF(name) #name
#define KERF_LANES_TEXT(name) KERF_LANES_TEXT_OF(name)

namespace kerf::lanes {

namespace KERF_LANES {
template <int D, class Real>
inline constexpr WalksOf<D, Real> all_walks{walk_fluid<D, Real>, gather_bonds<D, Real>,
                                            push_bonds<D, Real>};
}

extern const Walks KERF_LANES_TABLE(KERF_LANES);
const Walks KERF_LANES_TABLE(KERF_LANES){KERF_LANES_TEXT(KERF_LANES),
                                         KERF_LANES::all_walks<2, float>,
                                         KERF_LANES::all_walks<3, float>,
                                         KERF_LANES::all_walks<2, double>,
                                         KERF_LANES::all_walks<3, double>,
                                         KERF_LANES::search<2>,
                                         KERF_LANES::search<3>};

}  // namespace kerf::lanes
