// SPDX-License-Identifier: Apache-2.0
// The groups in which sums over particles are formed (parallel/group_sum.hpp). A group has the
// particles of some consecutive cells of one row of a grid (neighbours/grid.hpp), in the order in
// which they were sorted; a particle that has joined since then is a group of its own. So which
// particles are in a group, and in which order, follows from their state alone.
#pragma once

#include "parallel/group_sum.hpp"

namespace kerf {

inline constexpr Index unsorted = ~Index(0);  // in place of the cell of a particle
inline constexpr int most_levels = 5;         // of resolution

// How the cells of the grids of all levels are numbered.
struct GridRows {
  static constexpr Index cells_of_piece = 12;  // a piece has some 27 particles in 2D, 40 in 3D

  int levels = 1;
  Index first[most_levels + 1] = {0, unsorted};  // cell of a level
  Index across[most_levels] = {unsorted};        // cells of a row

  // Returns the number of the piece of a row to which a cell belongs.
  KERF_FUNCTION Index piece(Index cell) const {
    constexpr Index length = cells_of_piece;
    int level = 0;
    while (level + 1 < levels && cell >= first[level + 1]) ++level;
    const Index number = cell - first[level], row = number / across[level];
    const Index pieces = across[level] / length + 1;
    return first[level] + row * pieces + (number - row * across[level]) / length;
  }
};

// Whether a particle is the first one of its group.
struct StartsGroup {
  const Index* cell;  // of each particle when it was sorted
  GridRows rows;

  KERF_FUNCTION bool operator()(Index i) const {
    if (i == 0 || cell[i] == unsorted || cell[i - 1] == unsorted) return true;
    return cell[i] != cell[i - 1] && rows.piece(cell[i]) != rows.piece(cell[i - 1]);
  }
};

class ParticleGroups {
 public:
  void set_rows(const GridRows& rows) { rows_ = rows; }
  const GridRows& rows() const { return rows_; }

  // Finds the groups of the first particles, given the cell of each when it was sorted.
  void find([[maybe_unused]] const Array<Index>& sorted_cell, [[maybe_unused]] Index count) {
#if !defined(__CUDACC__)  // there no sum goes by groups
    begin_.resize(count + 1);
    const auto last = thrust::copy_if(loop_policy(), thrust::counting_iterator<Index>(0),
                                      thrust::counting_iterator<Index>(count), begin_.begin(),
                                      StartsGroup{pointer(sorted_cell), rows_});
    *last = count;
    count_ = static_cast<Index>(last - begin_.begin());
#endif
  }
  GroupView view() const {
    return {pointer(begin_), count_};
  }

  std::size_t bytes() const {
    return begin_.size() * sizeof(Index);
  }

 private:
  GridRows rows_;
  Array<Index> begin_;
  Index count_ = 0;
};

}  // namespace kerf
