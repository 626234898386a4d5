// SPDX-License-Identifier: Apache-2.0
// The pieces of a solid: two particles are in one piece when a chain of bonds joins them that still
// transmit tension. Such a bond is unbroken, and softening or flaws have left tension to at least
// one of its ends, since its force is the sum of the shares of both (solid/bond_force.hpp). The law
// of softening reaches zero at a finite strain, so this needs no threshold. How far a bond is
// stretched does not matter, and bonds of every length count: a particle pair across a crack that
// is still bonded is pulled together, and when the crack opens its own strain breaks it.
#pragma once

#include <boost/pending/disjoint_sets.hpp>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mirror_planes.hpp"
#include "parallel/loops.hpp"

namespace kerf {

// By number of the solid's particles.
struct SolidPieces {
  std::vector<Index> piece, body_piece;  // the lowest number in the piece, as in Frame
  std::vector<std::uint8_t> planes;      // Frame::joined_planes
};

// Returns the lowest member of the set of each element.
inline std::vector<Index> lowest_members(boost::disjoint_sets_with_storage<>& sets, Index count) {
  std::vector<Index> lowest(count, count), label(count);
  for (Index s = 0; s < count; ++s) {
    Index& first = lowest[sets.find_set(s)];
    if (first == count) first = s;
    label[s] = first;
  }
  return label;
}

// `solid` gives view(), size() and tension_left(s); `body`: the body of each of its particles.
template <int D, class Solid>
SolidPieces find_solid_pieces(const Solid& solid, const std::vector<std::uint16_t>& body) {
  const auto& view = solid.view();
  const Index count = solid.size();
  boost::disjoint_sets_with_storage<> sets(count);
  for (Index s = 0; s < count; ++s) sets.make_set(s);
  std::vector<std::uint8_t> planes(count, 0), bears(count, 0);
  for (Index s = 0; s < count; ++s) bears[s] = solid.tension_left(s) > 0 ? 1 : 0;
  std::vector<std::pair<Index, Index>> between_bodies;
  for (Index s = 0; s < count; ++s)
    for (Index k = view.bonds.first(s); k < view.bonds.last(s); ++k) {
      const auto end = view.bond_end(s, k);
      const bool counted_from_there = end.mirror == 0 && end.particle > s;
      if (counted_from_there || !view.is_intact(s, k)) continue;
      if (bears[s] == 0 && bears[end.particle] == 0) continue;
      planes[s] |= static_cast<std::uint8_t>(end.mirror >> MirrorPlanes<D>::shift);
      if (body[s] == body[end.particle])
        sets.union_set(s, end.particle);
      else
        between_bodies.emplace_back(s, end.particle);
    }
  SolidPieces pieces;
  pieces.body_piece = lowest_members(sets, count);
  pieces.planes.assign(count, 0);
  for (Index s = 0; s < count; ++s) pieces.planes[pieces.body_piece[s]] |= planes[s];
  for (Index s = 0; s < count; ++s) pieces.planes[s] = pieces.planes[pieces.body_piece[s]];
  for (const auto& [a, b] : between_bodies) sets.union_set(a, b);
  pieces.piece = lowest_members(sets, count);
  return pieces;
}

}  // namespace kerf
