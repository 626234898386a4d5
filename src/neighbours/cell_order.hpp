// SPDX-License-Identifier: Apache-2.0
// CellTable knows which particles are in which cell. After a sort the particles themselves are in
// the order of their cells; later, when some have moved into other cells, a table lists them in
// that order.
#pragma once

#include "neighbours/level_grids.hpp"
#include "particles/reorder.hpp"

namespace kerf {

template <int D, class P>
struct CellNumber {
  ParticleView<D, P> particles;
  LevelGrids<D> grids;
  Index* number;

  KERF_FUNCTION void operator()(Index i) const {
    number[i] = grids.number(particles.medium(i).level, particles.build_position[i]);
  }
};

// The particles in the order of their cells, as numbers from 0 on: places.
struct CellOrder {
  const Index* particle_at;  // of each place; null: the particles are in this order
  const Index* cell;         // of each particle
  const Index* begin;        // the place where each cell begins

  KERF_FUNCTION Index particle(Index place) const {
    return particle_at == nullptr ? place : particle_at[place];
  }
};

// Sets where each cell begins: the particle at a place, or their end, begins the cells after its
// predecessor's up to its own.
struct BeginCells {
  CellOrder order;
  Index particles, cells;
  Index* begin;  // of cells + 1

  KERF_FUNCTION void operator()(Index place) const {
    const Index first = place == 0 ? 0 : order.cell[order.particle(place - 1)] + 1;
    const Index last = place == particles ? cells : order.cell[order.particle(place)];
    for (Index cell = first; cell <= last; ++cell) begin[cell] = place;
  }
};

// Whether a particle is in a cell before that of its predecessor.
struct ComesTooLate {
  const Index* cell;
  KERF_FUNCTION bool operator()(Index i) const { return i > 0 && cell[i] < cell[i - 1]; }
};

template <int D, class P>
class CellTable {
 public:
  // Returns the cell numbers of the build positions, the sort key of the particles.
  const Array<Index>& number(Particles<D, P>& particles, const LevelGrids<D>& grids) {
    cell_.resize(particles.size());
    for_each_index(particles.size(), CellNumber<D, P>{particles.view(), grids, pointer(cell_)});
    return cell_;
  }
  // Takes the build positions of particles in any order.
  void build(Particles<D, P>& particles, const LevelGrids<D>& grids) {
    const Index n = particles.size(), cells = grids.count();
    number(particles, grids);
    has_table_ = particles.ghosts.count > 0 ||
                 reduce_unordered(n, ComesTooLate{pointer(cell_)}, false, Either{});
    if (has_table_) {
      key_ = cell_;
      particle_at_.resize(n);
      thrust::sequence(loop_policy(), particle_at_.begin(), particle_at_.end());
      thrust::stable_sort_by_key(loop_policy(), key_.begin(), key_.end(), particle_at_.begin());
    }
    if (particles.ghosts.count > 0)
      for_each_index(n, SortRun{pointer(key_),
                                {pointer(particles.sorted_cell), pointer(particles.id)},
                                n,
                                pointer(particle_at_)});
    begin_.resize(cells + 1);
    for_each_index(n + 1, BeginCells{view(), n, cells, pointer(begin_)});
  }

  CellOrder view() const {
    return {has_table_ ? pointer(particle_at_) : nullptr, pointer(cell_), pointer(begin_)};
  }
  std::size_t entries() const {
    return cell_.size() + begin_.size() + key_.size() + particle_at_.size();
  }

 private:
  bool has_table_ = false;  // whether the particles themselves are in another order
  Array<Index> cell_, begin_, particle_at_;
  Array<Index> key_;  // scratch of the sort
};

}  // namespace kerf
