// SPDX-License-Identifier: Apache-2.0
// The patches (neighbours/patch_grids.hpp) by which ranks have ghosts: a rank has all particles of
// the patches around those of its own particles.
#pragma once

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
    const int level = particles.media[particles.source[i]].level;
    int at[D];
    for (int a = 0; a < D; ++a)
      at[a] = grids.grid[level].coordinate(particles.build_position[i][a], a) /
              PatchGrids<D>::cells_across;
    patch[i] = patches.first[level] + patches.grid[level].number(at);
  }
  return patch;
}

// Calls visit(first, last) for each row of the patches of all levels adjacent to one, which is
// among them.
template <int D, class Visit>
void for_each_row_around(Index number, const LevelGrids<D>& grids, const PatchGrids<D>& patches,
                         const Visit& visit) {
  const auto patch = patches.find(number);
  for (int level = 0; level < patches.levels; ++level)
    for_each_adjacent_row(grids, patches, patch, level, [&](Index first, Index last) {
      visit(patches.first[level] + first, patches.first[level] + last);
    });
}

}  // namespace kerf
