// SPDX-License-Identifier: Apache-2.0
// PiecesOfRows tells by which pieces of rows of cells (particles/particle_groups.hpp) particles are
// distributed among ranks: a piece has one rank, so that the groups in which sums are formed are
// never divided.
#pragma once

#include <vector>

#include "distributed/partition.hpp"
#include "neighbours/level_grids.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
class PiecesOfRows {
 public:
  // Both must live as long as this object.
  PiecesOfRows(const Particles<D, P>& particles, const LevelGrids<D>& grids)
      : particles_(particles), grids_(grids), cell_(particles.size()) {
    // The cells in which the particles were sorted, so that groups stay whole.
    for (Index i = 0; i < particles.size(); ++i)
      cell_[i] = particles.sorted_cell[i] != unsorted
                     ? particles.sorted_cell[i]
                     : grids.number(particles.media[particles.source[i]].level,
                                    particles.build_position[i]);
  }

  // The work of a particle, 1.
  float work(Index i) const {
    constexpr float of_rigid = 0.1f;  // no pairs are summed for it
    return particles_.media[particles_.source[i]].phase == Phase::rigid ? of_rigid : 1.0f;
  }

  // The work of the particles at the centres of their pieces, where consecutive particles of one
  // piece are one point.
  std::vector<PointOfWork> points() const {
    std::vector<PointOfWork> points;
    for (Index i = 0; i < particles_.size(); ++i) {
      if (is_new_piece(i)) points.push_back({centre(grids_, cell_[i]), 0.0f});
      points.back().work += work(i);
    }
    return points;
  }

  // The rank of each particle; null: rank 0 has all.
  std::vector<int> owners(const Partition* partition) const {
    std::vector<int> ranks(particles_.size());
    int rank = 0;
    for (Index i = 0; i < particles_.size(); ++i) {
      if (partition != nullptr && is_new_piece(i))
        rank = partition->owner(centre(grids_, cell_[i]));
      ranks[i] = rank;
    }
    return ranks;
  }

  // The centre of the piece of a row to which a cell belongs, m, moved a little along each axis by
  // its place along the next one: a cut of an axis thus divides the pieces of one layer of cells.
  static std::array<double, 3> centre(const LevelGrids<D>& grids, Index cell) {
    const int level = grids.level_of(cell);
    const Grid<D>& grid = grids.grid[level];
    cell -= grids.first[level];
    std::array<double, 3> point{};
    for (int a = 0; a < D; ++a) {
      const auto across = static_cast<Index>(grid.cells[a]);
      const Index at = cell % across, length = a == 0 ? GridRows::cells_of_piece : 1;
      point[static_cast<std::size_t>(a)] =
          grid.origin[a] + grid.cell * (double(at - at % length) + 0.5 * double(length));
      cell /= across;
    }
    std::array<double, 3> moved = point;
    constexpr double tilt = 1e-3;
    for (int a = 0; a < D; ++a) {
      const auto axis = static_cast<std::size_t>(a), next = static_cast<std::size_t>((a + 1) % D),
                 last = static_cast<std::size_t>((a + 2) % D);
      moved[axis] += tilt * point[next];
      if (D == 3) moved[axis] += golden * tilt * point[last];
    }
    return moved;
  }

 private:
  static constexpr double golden = 0.618;  // no two pieces of a layer are moved alike

  bool is_new_piece(Index i) const {
    return i == 0 || (cell_[i] != cell_[i - 1] &&
                      grids_.rows().piece(cell_[i]) != grids_.rows().piece(cell_[i - 1]));
  }

  const Particles<D, P>& particles_;
  const LevelGrids<D>& grids_;
  std::vector<Index> cell_;
};

}  // namespace kerf
