// SPDX-License-Identifier: Apache-2.0
// The lists of a GPU: found once to be counted and once more to be written, since its threads have
// no lists of their own that could grow.
#pragma once

#include "neighbours/find_neighbours.hpp"
#include "neighbours/list_in_blocks.hpp"

namespace kerf {

template <int D, class P, class Scheme>
struct CountNeighbours {
  FindNeighbours<D, P, Scheme> find;
  ListPlaces places;  // `begin` gets the count

  KERF_FUNCTION void operator()(Index i) const {
    CountedSections found;
    find(i, found);
    places.alike[i] = found.count[static_cast<int>(Kinship::alike)];
    places.own[i] = found.count[static_cast<int>(Kinship::own)];
    places.begin[i] =
        places.alike[i] + places.own[i] + found.count[static_cast<int>(Kinship::other)];
  }
};

template <int D, class P, class Scheme>
struct WriteNeighbours {
  FindNeighbours<D, P, Scheme> find;
  ListPlaces places;
  Index* neighbour;

  KERF_FUNCTION void operator()(Index i) const {
    Index* const alike = neighbour + places.begin[i];
    Index* const own = alike + places.alike[i];
    PlacedSections found;
    found.next[static_cast<int>(Kinship::alike)] = alike;
    found.next[static_cast<int>(Kinship::own)] = own;
    found.next[static_cast<int>(Kinship::other)] = own + places.own[i];
    find(i, found);
    places.end[i] = places.begin[i + 1];
  }
};

}  // namespace kerf
