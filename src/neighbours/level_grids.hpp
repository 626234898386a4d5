// SPDX-License-Identifier: Apache-2.0
// LevelGrids has one grid for each level of resolution (docs/theory/graded_resolution.md), each
// with cells half as wide as the cutoff of its level: in a grid for the longest cutoff a small
// particle would test hundreds of others in vain, and with cells as wide as the cutoff it would
// test seven candidates for each neighbour (half as wide: four). The numbers of cells run on from
// level to level. A particle searches each grid up to the longest cutoff between its level and that
// one.
#pragma once

#include <algorithm>
#include <vector>

#include "model/medium.hpp"
#include "neighbours/grid.hpp"
#include "particles/particle_groups.hpp"

namespace kerf {

// The longest cutoff between particles of two levels, m, without the skin.
struct LevelReach {
  int levels = 1;
  double longest[most_levels][most_levels] = {};

  template <int D, class Scheme>
  static LevelReach of(const std::vector<Medium<double>>& media) {
    LevelReach reach;
    for (const auto& a : media)
      for (const auto& b : media) {
        reach.levels = std::max(reach.levels, a.level + 1);
        double& longest = reach.longest[a.level][b.level];
        longest = std::max(longest, Scheme::template Kernel<D>::support *
                                        Scheme::template smoothing_length<double>(a, b));
      }
    return reach;
  }
  static LevelReach one(double longest) {
    LevelReach reach;
    reach.longest[0][0] = longest;
    return reach;
  }
};

template <int D>
struct LevelGrids {
  int levels = 0;
  Grid<D> grid[most_levels];
  Index first[most_levels + 1];            // number of the first cell of a level
  double limit[most_levels][most_levels];  // m, the cutoff between the two with the skin

  static LevelGrids covering(const Vector<D, double>& minimum, const Vector<D, double>& maximum,
                             const LevelReach& reach, double skin) {
    constexpr double most_cells = 1.6e7;
    // A little wider than a half, so that rounding never adds a cell to two cutoffs.
    constexpr double half_limit = 0.5 * (1.0 + 1e-6);
    LevelGrids grids;
    grids.levels = reach.levels;
    grids.first[0] = 0;
    for (int a = 0; a < reach.levels; ++a) {
      grids.grid[a] = Grid<D>::covering(minimum, maximum, half_limit * (reach.longest[a][a] + skin),
                                        most_cells);
      grids.first[a + 1] = grids.first[a] + grids.grid[a].count();
      for (int b = 0; b < reach.levels; ++b) grids.limit[a][b] = reach.longest[a][b] + skin;
    }
    return grids;
  }

  KERF_FUNCTION Index number(int level, const Vector<D, double>& x) const {
    return first[level] + grid[level].number(x);
  }
  Index count() const { return first[levels]; }
  // The level to which a cell belongs.
  int level_of(Index cell) const {
    int level = 0;
    while (cell >= first[level + 1]) ++level;
    return level;
  }
  GridRows rows() const {
    GridRows rows;
    rows.levels = levels;
    for (int a = 0; a < levels; ++a) {
      rows.first[a] = first[a];
      rows.across[a] = static_cast<Index>(grid[a].cells[0]);
    }
    rows.first[levels] = count();
    return rows;
  }
};

// Calls take(begin, end) for the particles of a row of cells, given where the cells begin in the
// order of the cells (neighbours/cell_order.hpp).
template <class Take>
struct ParticlesOfRow {
  const Index* begin_of;
  const Take& take;

  KERF_FUNCTION void operator()(Index first, Index last) const {
    take(begin_of[first], begin_of[last + 1]);
  }
};

}  // namespace kerf
