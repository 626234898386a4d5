// SPDX-License-Identifier: Apache-2.0
// PatchGrids joins three by three (by three) cells of each grid (neighbours/level_grids.hpp) to a
// patch, one and a half times as wide as the cutoff of its level. The numbers of patches run on
// from level to level.
#pragma once

#include "neighbours/level_grids.hpp"

namespace kerf {

template <int D>
struct PatchGrids {
  static constexpr int cells_across = 3;

  int levels = 0;
  Grid<D> grid[most_levels];
  Index first[most_levels + 1];  // number of the first patch of a level

  static PatchGrids of(const LevelGrids<D>& cells) {
    PatchGrids patches;
    patches.levels = cells.levels;
    patches.first[0] = 0;
    for (int level = 0; level < cells.levels; ++level) {
      auto& grid = patches.grid[level];
      grid = cells.grid[level];
      grid.cell *= cells_across;
      grid.per_cell /= cells_across;
      for (int& count : grid.cells) count = (count + cells_across - 1) / cells_across;
      patches.first[level + 1] = patches.first[level] + grid.count();
    }
    return patches;
  }
  Index count() const { return first[levels]; }

  struct Patch {
    int level;
    int at[D];
  };
  KERF_FUNCTION Patch find(Index number) const {
    Patch patch{0, {}};
    while (number >= first[patch.level + 1]) ++patch.level;
    number -= first[patch.level];
    for (int a = 0; a < D; ++a) {
      const auto across = static_cast<Index>(grid[patch.level].cells[a]);
      patch.at[a] = static_cast<int>(number % across);
      number /= across;
    }
    return patch;
  }
  // Its sides; what lies outside the domain belongs to the patches at its edge.
  KERF_FUNCTION double low_side(const Patch& patch, int a) const {
    return grid[patch.level].origin[a] + patch.at[a] * grid[patch.level].cell;
  }
  KERF_FUNCTION double high_side(const Patch& patch, int a) const {
    return low_side(patch, a) + grid[patch.level].cell;
  }
};

// Patches within this many cutoffs of one another are adjacent. It is a little less than the width
// of a patch, so that rounding adds no patch.
inline constexpr double patch_margin = 1.5 * (1.0 - 1e-6);

// Calls visit(first, last) for each row of the patches of a level that are adjacent to a patch, of
// which it is one; they are numbered within their level. `cells`: the grids of the patches.
template <int D, class Visit>
KERF_FUNCTION void for_each_adjacent_row(const LevelGrids<D>& cells, const PatchGrids<D>& patches,
                                         const typename PatchGrids<D>::Patch& patch, int level,
                                         const Visit& visit) {
  const double margin = patch_margin * cells.limit[patch.level][level];
  Vector<D, double> minimum, maximum;
  for (int a = 0; a < D; ++a) {
    minimum[a] = patches.low_side(patch, a) - margin;
    maximum[a] = patches.high_side(patch, a) + margin;
  }
  patches.grid[level].for_each_row(minimum, maximum, visit);
}

// Calls take(begin, end) for each run of places (neighbours/cell_order.hpp) of a patch.
// `cell_begin`: where each cell begins.
template <int D, class Take>
KERF_FUNCTION void for_each_run(const LevelGrids<D>& cells, const Index* cell_begin,
                                const typename PatchGrids<D>::Patch& patch, const Take& take) {
  constexpr int across = PatchGrids<D>::cells_across;
  const auto& grid = cells.grid[patch.level];
  int low[D], high[D];
  for (int a = 0; a < D; ++a) {
    low[a] = across * patch.at[a];
    high[a] = low[a] + across < grid.cells[a] ? low[a] + across - 1 : grid.cells[a] - 1;
  }
  grid.for_each_row(low, high, ParticlesOfRow<Take>{cell_begin + cells.first[patch.level], take});
}

}  // namespace kerf
