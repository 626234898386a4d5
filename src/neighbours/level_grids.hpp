// SPDX-License-Identifier: Apache-2.0
// One grid for each level of resolution (docs/theory/graded_resolution.md), each with cells half as
// wide as the kernels of its level reach: in a grid for the longest kernel a small particle would
// look at hundreds of others in vain, and with cells as wide as the reach it would look at seven
// for each that it sees (half as wide: four). Cells are numbered through, level after level; a
// particle looks into each grid as far as any particle of that level can be seen by one of its own.
#pragma once

#include <algorithm>
#include <vector>

#include "neighbours/grid.hpp"
#include "particles/medium.hpp"

namespace kerf {

inline constexpr int most_levels = 5;

// m, without the skin: how far particles of two levels see one another at most.
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
  double limit[most_levels][most_levels];  // m, how far the first looks for the second

  static LevelGrids covering(const Vector<D, double>& minimum, const Vector<D, double>& maximum,
                             const LevelReach& reach, double skin) {
    constexpr double most_cells = 1.6e7;
    // A hair wider than a half, so that two limits never touch on a cell more by rounding.
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
};

// Of rows of cells: take(begin, end) of the particles in them, from where the cells begin.
template <class Take>
struct ParticlesOfRow {
  const Index* begin_of;
  const Take& take;

  KERF_FUNCTION void operator()(Index first, Index last) const {
    take(begin_of[first], begin_of[last + 1]);
  }
};

}  // namespace kerf
