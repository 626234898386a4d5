// SPDX-License-Identifier: Apache-2.0
// The pieces of a solid: two particles are in one piece when a chain of bonds joins them that still
// transmit tension. Such a bond is unbroken, and softening or flaws have left tension to at least
// one of its ends, since its force is the sum of the shares of both (solid/bond_force.hpp). The law
// of softening reaches zero at a finite strain, so this needs no threshold. How far a bond is
// stretched does not matter, and bonds of every length count: a particle pair across a crack that
// is still bonded is pulled together, and when the crack opens its own strain breaks it.
#pragma once

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cstdint>
#include <vector>

#include "core/mirror_planes.hpp"
#include "parallel/loops.hpp"

namespace kerf {

// By number of the solid's particles.
struct SolidPieces {
  std::vector<Index> piece, body_piece;  // the lowest number in the piece, as in Frame
  std::vector<std::uint8_t> planes;      // Frame::joined_planes
};

inline constexpr Index unlabelled = ~Index(0);

// Labels particle `first`, and all without a label to which some of the bonds of each lead from it,
// with `first`. `joins(s, k)`: whether bond k of particle s counts.
template <class View, class Joins>
void label_by_some_bonds(const View& view, Index first, const Joins& joins,
                         std::vector<Index>& label) {
  constexpr Index tried = 8;  // of the bonds of a particle, evenly spread over its list
  std::vector<Index> open{first};
  label[first] = first;
  while (!open.empty()) {
    const Index s = open.back();
    open.pop_back();
    const Index bonds = view.bonds.last(s) - view.bonds.first(s);
    for (Index n = 0; n < std::min(tried, bonds); ++n) {
      const Index k = view.bonds.first(s) + n * bonds / std::min(tried, bonds);
      const Index other = view.bond_end(s, k).particle;
      if (label[other] != unlabelled || !joins(s, k)) continue;
      label[other] = first;
      open.push_back(other);
    }
  }
}

// Returns for every particle the lowest number in its piece. A few bonds of each particle join
// nearly all; the others are tried where they do not join a particle to the largest piece. Since a
// bond is in the lists of both its ends, none is left out.
template <class View, class Joins>
std::vector<Index> label_pieces(const View& view, Index count, const Joins& joins) {
  std::vector<Index> label(count, unlabelled), size(count, 0);
  for (Index first = 0; first < count; ++first)
    if (label[first] == unlabelled) label_by_some_bonds(view, first, joins, label);
  for (const Index piece : label) ++size[piece];
  const auto largest =
      static_cast<Index>(std::max_element(size.begin(), size.end()) - size.begin());
  boost::disjoint_sets_with_storage<> pieces(count);
  for (Index s = 0; s < count; ++s) pieces.make_set(s);
  for (Index s = 0; s < count; ++s) {
    if (label[s] == largest) continue;
    for (Index k = view.bonds.first(s); k < view.bonds.last(s); ++k)
      if (joins(s, k)) pieces.union_set(label[s], label[view.bond_end(s, k).particle]);
  }
  std::vector<Index> lowest(count, unlabelled);
  for (Index s = 0; s < count; ++s) {
    const auto piece = pieces.find_set(label[s]);
    lowest[piece] = std::min(lowest[piece], s);
    label[s] = lowest[piece];
  }
  return label;
}

// `solid` gives view(), size() and tension_left(s); `body`: the body of each of its particles.
template <int D, class Solid>
SolidPieces find_solid_pieces(const Solid& solid, const std::vector<std::uint16_t>& body) {
  const auto& view = solid.view();
  const Index count = solid.size();
  std::vector<std::uint8_t> planes(count, 0), bears(count, 0);
  for (Index s = 0; s < count; ++s) bears[s] = solid.tension_left(s) > 0 ? 1 : 0;
  const auto holds = [&](Index s, Index k) {
    return view.is_intact(s, k) && (bears[s] != 0 || bears[view.bond_end(s, k).particle] != 0);
  };
  for (Index s = 0; s < count; ++s)
    for (Index k = view.bonds.last(s); k > view.bonds.first(s); --k) {
      const MirrorCode mirror = view.bond_end(s, k - 1).mirror;
      if (mirror == 0) break;  // bonds to images come last
      if (holds(s, k - 1)) planes[s] |= static_cast<std::uint8_t>(mirror >> MirrorPlanes<D>::shift);
    }
  SolidPieces pieces;
  pieces.body_piece = label_pieces(view, count, [&](Index s, Index k) {
    return body[s] == body[view.bond_end(s, k).particle] && holds(s, k);
  });
  pieces.planes.assign(count, 0);
  for (Index s = 0; s < count; ++s) pieces.planes[pieces.body_piece[s]] |= planes[s];
  for (Index s = 0; s < count; ++s) pieces.planes[s] = pieces.planes[pieces.body_piece[s]];
  const bool is_one_body = std::all_of(body.begin(), body.end(),
                                       [&](std::uint16_t other) { return other == body.front(); });
  pieces.piece = is_one_body ? pieces.body_piece : label_pieces(view, count, holds);
  return pieces;
}

}  // namespace kerf
