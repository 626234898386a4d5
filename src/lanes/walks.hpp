// SPDX-License-Identifier: Apache-2.0
// The walks over neighbours and bonds that run several at a time, in registers as wide as the
// processor has them. Each is compiled for several instruction sets; which one runs is chosen once,
// when it is first asked for.
#pragma once

#include "exec/exec.hpp"
#include "lanes/packed_bonds.hpp"
#include "lanes/packed_fluid.hpp"
#include "lanes/packed_search.hpp"

namespace kerf {

// Walks are for processors; on a GPU the general loops do all.
inline constexpr bool lanes_exist = !on_gpu;

template <int D, class Real>
struct WalksOf {
  FluidWalk<D, Real> fluid;
  BondWalk<D, Real, BondGradient> gather_bonds;
  BondWalk<D, Real, BondPush> push_bonds;
};

struct Walks {
  const char* name;  // of the instruction set
  WalksOf<2, float> single_2d;
  WalksOf<3, float> single_3d;
  WalksOf<2, double> double_2d;
  WalksOf<3, double> double_3d;
  Search<2> search_2d;
  Search<3> search_3d;

  template <int D, class Real>
  const WalksOf<D, Real>& get() const {
    constexpr bool single = sizeof(Real) == sizeof(float);
    if constexpr (D == 2 && single) return single_2d;
    if constexpr (D == 3 && single) return single_3d;
    if constexpr (D == 2 && !single) return double_2d;
    if constexpr (D == 3 && !single) return double_3d;
  }
};

template <int D>
Search<D> search_of(const Walks& walks) {
  if constexpr (D == 2) return walks.search_2d;
  if constexpr (D == 3) return walks.search_3d;
}

// Those for this processor; the environment's KERF_LANES (baseline, avx2, avx512) may ask for less.
const Walks& walks();

}  // namespace kerf
