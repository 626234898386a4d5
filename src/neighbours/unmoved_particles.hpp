// SPDX-License-Identifier: Apache-2.0
// UnmovedParticles lists the particles without a mark in the order of their cells
// (neighbours/cell_order.hpp), so that those of a row of cells follow one another.
#pragma once

#include "neighbours/cell_order.hpp"

namespace kerf {

struct UnmovedView {
  const Index* before;    // of each place, how many there are at the places before it
  const Index* particle;  // which they are
};

struct CountUnmoved {
  CellOrder order;
  const std::uint8_t* moved;
  Index* here;

  KERF_FUNCTION void operator()(Index place) const {
    here[place] = moved[order.particle(place)] == 0 ? 1 : 0;
  }
};

struct TakeUnmoved {
  CellOrder order;
  const std::uint8_t* moved;
  const Index* before;
  Index* particle;

  KERF_FUNCTION void operator()(Index place) const {
    const Index i = order.particle(place);
    if (moved[i] == 0) particle[before[place]] = i;
  }
};

class UnmovedParticles {
 public:
  // Takes those of the places 0 .. `places` - 1 whose particle is not marked in `moved`.
  void find(const CellOrder& order, Index places, const std::uint8_t* moved) {
    before_.resize(places + 1);
    particle_.resize(places);
    for_each_index(places, CountUnmoved{order, moved, pointer(before_)});
    thrust::fill_n(before_.begin() + places, 1, Index(0));
    thrust::exclusive_scan(loop_policy(), before_.begin(), before_.end(), before_.begin());
    for_each_index(places, TakeUnmoved{order, moved, pointer(before_), pointer(particle_)});
  }

  UnmovedView view() const { return {pointer(before_), pointer(particle_)}; }
  std::size_t entries() const { return before_.size() + particle_.size(); }

 private:
  Array<Index> before_, particle_;
};

}  // namespace kerf
