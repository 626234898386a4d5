// SPDX-License-Identifier: Apache-2.0
// What the searches for neighbours need of the particles, place by place
// (neighbours/cell_order.hpp).
#pragma once

#include "neighbours/cell_order.hpp"
#include "neighbours/pair_range.hpp"
#include "neighbours/simd/search_kernels.hpp"
#include "simd/packed_position.hpp"

namespace kerf {

// What the SIMD search (neighbours/simd/packed_search.hpp) and that of a GPU need of the particles,
// place by place.
template <int D>
struct SearchView {
  Search<D> search = nullptr;
  std::int32_t* position[D] = {};
  std::uint32_t* kind = nullptr;
  FixedPointScale<float> unit;
};
// Component a of the difference of two positions.
template <int D>
struct DifferenceTo {
  const Vector<D, double>&x, &y;
  KERF_FUNCTION double operator()(int a) const { return x[a] - y[a]; }
};
template <int D, class P, class Scheme>
struct PackForSearch {
  ParticleView<D, P> particles;
  CellOrder order;
  SearchView<D> packed;

  KERF_FUNCTION void operator()(Index place) const {
    const Index i = order.particle(place);
    for (int a = 0; a < D; ++a)
      packed.position[a][place] = packed.unit.pack(particles.build_position[i][a]);
    packed.kind[place] = Scheme::kind(particles, i);
  }
};

// Particle i at its position x, or its mirror image at x.
template <int D>
struct ListViewer {
  Index i;
  MirrorCode code;
  Vector<D, double> x;
  double limit;  // m, the largest cutoff to particles of a level
};
struct PlaceRange {
  Index begin, end;
};

// Tests the candidates of a row of cells by their packed coordinates, on a GPU. Those of another
// kind are tested once more. `Find` is FindNeighbours.
template <class Find, int D, class Sections>
struct ScanPackedRow {
  const Find& find;
  const ListViewer<D>& from;
  std::int32_t position[D];
  std::uint32_t kind;
  float limit_squared, same_squared;  // in the unit of the coordinates
  PairClass same_class;
  Sections& found;

  KERF_FUNCTION void operator()(Index begin, Index end) const {
    for (Index place = begin; place < end; ++place) {
      float square = 0.0f;
      for (int a = 0; a < D; ++a) {
        const auto d =
            static_cast<float>(wrapping_difference(find.packed.position[a][place], position[a]));
        square += d * d;
      }
      if (!(square < limit_squared)) continue;
      if (find.packed.kind[place] != kind) {
        find.scan(from, {place, place + 1}, found);
      } else if (const Index j = find.order.particle(place); square < same_squared && j != from.i) {
        if (Index* const next = found.room(same_class, 1)) *next = j;
        found.took(same_class, 1);
      }
    }
  }
};

}  // namespace kerf
