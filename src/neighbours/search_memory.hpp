// SPDX-License-Identifier: Apache-2.0
// SearchMemory is what a thread keeps from particle to particle of a search: the rows of cells
// around a cell, and what is common to pairs of two kinds.
#pragma once

#include "neighbours/kinds_of_pairs.hpp"
#include "neighbours/level_grids.hpp"
#include "neighbours/simd/packed_search.hpp"

namespace kerf {

// The rows of cells around the particles of one cell, which are looked up once for all of them.
struct CellRows {
  static constexpr Index no_cell = ~Index(0);

  Index cell = no_cell;  // set where one search takes all their rows
  SearchRows rows;
};

struct SearchMemory {
  CellRows of_level[most_levels];
  KindsOfPairs kinds;

  void forget() {
    for (CellRows& rows : of_level) rows.cell = CellRows::no_cell;
    kinds.forget();
  }
};

}  // namespace kerf
