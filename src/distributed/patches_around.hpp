// SPDX-License-Identifier: Apache-2.0
// The patches (neighbours/patch_grids.hpp) by which ranks have ghosts: a rank has all particles of
// the patches around those of its own particles.
#pragma once

#include <algorithm>
#include <vector>

#include "neighbours/patch_grids.hpp"
#include "particles/fields.hpp"

namespace kerf {

// Returns the patch in which each particle was listed.
template <int D, class P>
std::vector<Index> patches_of_particles(const Particles<D, P>& particles,
                                        const LevelGrids<D>& grids, const PatchGrids<D>& patches) {
  std::vector<Index> patch(particles.size());
  for (Index i = 0; i < particles.size(); ++i) {
    int at[D];
    for (int a = 0; a < D; ++a)
      at[a] =
          grids.grid[0].coordinate(particles.build_position[i][a], a) / PatchGrids<D>::cells_across;
    patch[i] = patches.grid[0].number(at);
  }
  return patch;
}

// Calls visit(first, last) for each row of the patches around one, itself too.
template <int D, class Visit>
void for_each_row_around(Index number, const Grid<D>& patches, const Visit& visit) {
  int low[D], high[D];
  for (int a = 0; a < D; ++a) {
    const auto across = static_cast<Index>(patches.cells[a]);
    const auto at = static_cast<int>(number % across);
    low[a] = std::max(at - 1, 0);
    high[a] = std::min(at + 1, patches.cells[a] - 1);
    number /= across;
  }
  patches.for_each_row(low, high, visit);
}

}  // namespace kerf
