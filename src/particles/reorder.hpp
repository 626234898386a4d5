// SPDX-License-Identifier: Apache-2.0
// This file reorders and removes particles: every state field is gathered by one list of indices.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

// Particle k of the result is particle order[k]. Scratch fields are only resized.
template <int D, class P>
void gather_particles(Particles<D, P>& particles, const Array<Index>& order) {
  particles.for_each_state([&](const char*, auto& field) { gather_in_place(order, field); });
  particles.resize(static_cast<Index>(order.size()));
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

// Sorts the particles by their keys; those of equal keys keep their order.
template <int D, class P>
void sort_particles(Particles<D, P>& particles, const Array<Index>& key) {
  TemporaryIndices<0> sorted;
  TemporaryIndices<1> order;
  *sorted = key;
  order->resize(particles.size());
  thrust::sequence(loop_policy(), order->begin(), order->end());
  thrust::stable_sort_by_key(loop_policy(), sorted->begin(), sorted->end(), order->begin());
  gather_particles(particles, *order);
}

}  // namespace kerf
