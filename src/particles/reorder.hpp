// SPDX-License-Identifier: Apache-2.0
// This file reorders and removes particles: every state field is gathered by one list of indices.
// Sorted particles have an order that follows from their cells and ids alone.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

// Particle k of the result is particle order[k]. Scratch fields are only resized.
template <int D, class P>
void gather_particles(Particles<D, P>& particles, const Array<Index>& order) {
  particles.for_each_state([&](const char*, auto& field) { gather_in_place(order, field); });
  particles.resize(static_cast<Index>(order.size()));
  particles.regroup();
}

template <int D, class P>
struct StaysIn {
  ParticleView<D, P> particles;
  KERF_FUNCTION bool operator()(Index i) const {
    return !particles.has(i, flag::outside | flag::erased);
  }
};

// Removes the particles that are marked for removal; the others keep their order.
template <int D, class P>
void remove_outflow(Particles<D, P>& particles) {
  Array<Index> order(particles.size());
  const auto last = thrust::copy_if(loop_policy(), thrust::counting_iterator<Index>(0),
                                    thrust::counting_iterator<Index>(particles.size()),
                                    order.begin(), StaysIn<D, P>{particles.view()});
  order.resize(static_cast<std::size_t>(last - order.begin()));
  if (order.size() < particles.size()) gather_particles(particles, order);
}

// The order of all particles: by the cell in which they were sorted, and there by their ids.
struct ComesBefore {
  const Index* sorted_cell;
  const std::uint32_t* id;

  KERF_FUNCTION bool operator()(Index i, Index j) const {
    return sorted_cell[i] != sorted_cell[j] ? sorted_cell[i] < sorted_cell[j] : id[i] < id[j];
  }
};

// Sorts each run of particles with equal keys. A run is short, and mostly in order.
struct SortRun {
  const Index* key;  // of each place, in order
  ComesBefore comes_before;
  Index count;
  Index* order;  // the particle at each place

  KERF_FUNCTION void operator()(Index first) const {
    if (first > 0 && key[first] == key[first - 1]) return;  // not the first one of a run
    for (Index next = first + 1; next < count && key[next] == key[first]; ++next) {
      const Index particle = order[next];
      Index place = next;
      for (; place > first && comes_before(particle, order[place - 1]); --place)
        order[place] = order[place - 1];
      order[place] = particle;
    }
  }
};

// Sorts the particles by their cells, and those of one cell by their ids.
template <int D, class P>
void sort_particles(Particles<D, P>& particles, const Array<Index>& cell) {
  TemporaryIndices<0> sorted;
  TemporaryIndices<1> order;
  particles.sorted_cell = cell;
  *sorted = cell;
  order->resize(particles.size());
  thrust::sequence(loop_policy(), order->begin(), order->end());
  thrust::stable_sort_by_key(loop_policy(), sorted->begin(), sorted->end(), order->begin());
  const ComesBefore comes_before{pointer(particles.sorted_cell), pointer(particles.id)};
  for_each_index(particles.size(),
                 SortRun{pointer(*sorted), comes_before, particles.size(), pointer(*order)});
  gather_particles(particles, *order);
}

}  // namespace kerf
