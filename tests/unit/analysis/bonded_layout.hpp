// SPDX-License-Identifier: Apache-2.0
// Frames of solids with bonds: pairs of the initial layout, some of them broken, and the pieces
// that follow from them, found by a search of the graph.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "layout.hpp"

namespace kerf::layout {

// Whether a bond between two positions of the initial layout is broken.
using Breaks = std::function<bool(const Position&, const Position&)>;

inline constexpr double bond_length = 2.6;  // spacings, 2 h of the standard formulation

// Sets the pieces of the solid particles of `frame`, whose first rows have the initial positions
// `initial`. Particles that are not intact have no bonds.
class BondGraph {
 public:
  BondGraph(const Frame& initial, const Frame& frame, const Breaks& breaks)
      : initial_(initial), frame_(frame), breaks_(breaks), cells_(cells_of(initial)) {}

  std::vector<std::uint32_t> pieces(bool within_bodies) const {
    std::vector<std::uint32_t> label = frame_.id;
    std::vector<bool> seen(initial_.id.size(), false);
    for (std::size_t start = 0; start < seen.size(); ++start) {
      if (seen[start]) continue;
      std::vector<std::size_t> open{start};
      seen[start] = true;
      while (!open.empty()) {
        const std::size_t a = open.back();
        open.pop_back();
        label[a] = frame_.id[start];
        for_each_bond(a, within_bodies, [&](std::size_t b) {
          if (seen[b]) return;
          seen[b] = true;
          open.push_back(b);
        });
      }
    }
    return label;
  }

 private:
  using Cell = std::array<long, 3>;
  static Cell cell_of(const Position& x) {
    const double width = bond_length * solid_spacing;
    return {std::lround(std::floor(x[0] / width)), std::lround(std::floor(x[1] / width)),
            std::lround(std::floor(x[2] / width))};
  }
  static std::map<Cell, std::vector<std::size_t>> cells_of(const Frame& initial) {
    std::map<Cell, std::vector<std::size_t>> cells;
    for (std::size_t k = 0; k < initial.id.size(); ++k)
      cells[cell_of(initial.position[k])].push_back(k);
    return cells;
  }
  bool is_bond(std::size_t a, std::size_t b, bool within_bodies) const {
    const Position &x = initial_.position[a], &y = initial_.position[b];
    return a != b && frame_.category[a] == Category::solid &&
           frame_.category[b] == Category::solid &&
           std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]) < bond_length * solid_spacing &&
           !(within_bodies && initial_.source[a] != initial_.source[b]) && !breaks_(x, y);
  }
  template <class Visit>
  void for_each_bond(std::size_t a, bool within_bodies, const Visit& visit) const {
    const Cell own = cell_of(initial_.position[a]);
    for (int n = 0; n < 27; ++n) {
      const auto found =
          cells_.find({own[0] + n % 3 - 1, own[1] + n / 3 % 3 - 1, own[2] + n / 9 - 1});
      if (found == cells_.end()) continue;
      for (const std::size_t b : found->second)
        if (is_bond(a, b, within_bodies)) visit(b);
    }
  }

  const Frame &initial_, &frame_;
  const Breaks& breaks_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

inline bool breaks_nothing(const Position&, const Position&) {
  return false;
}

inline void bond(const Frame& initial, Frame& frame, const Breaks& breaks = breaks_nothing) {
  const BondGraph graph(initial, frame, breaks);
  frame.piece = graph.pieces(false);
  frame.body_piece = graph.pieces(true);
}

// Adds water as add_water does to a frame with pieces: each particle of it is one of its own.
inline void add_water_beside_bonds(Frame& frame, const Case& description, double depth) {
  const std::size_t solids = frame.id.size();
  add_water(frame, description, depth, jet_width);
  for (std::size_t k = solids; k < frame.id.size(); ++k) {
    frame.piece.push_back(frame.id[k]);
    frame.body_piece.push_back(frame.id[k]);
  }
}

// The bonds that cross a line from the top face to the bottom one, x = at(y), break.
inline Breaks crack(const std::function<double(double)>& at) {
  return
      [at](const Position& x, const Position& y) { return (x[0] < at(x[1])) != (y[0] < at(y[1])); };
}

// A share of all other bonds breaks at random: the same for both orders of its ends.
inline Breaks and_at_random(const Breaks& breaks, double share, unsigned seed) {
  return [=](const Position& x, const Position& y) {
    if (breaks(x, y)) return true;
    std::uint64_t bits = std::hash<double>{}(x[0] + y[0]) ^ 3 * std::hash<double>{}(x[1] + y[1]) ^
                         7 * std::hash<double>{}(x[0] * y[0] + x[1] * y[1]) ^ seed;
    for (const std::uint64_t factor : {0xbf58476d1ce4e5b9u, 0x94d049bb133111ebu})
      bits = (bits ^ (bits >> 30)) * factor;
    return static_cast<double>(bits >> 11) * 0x1p-53 < share;
  };
}

}  // namespace kerf::layout
