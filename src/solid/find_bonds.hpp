// SPDX-License-Identifier: Apache-2.0
// BondFinder finds the bonds of the reference configuration, once, on the host: a cell grid, then
// each particle's list in ascending order, so that every sum has a fixed order; mirror images,
// whose entries have higher bits set, come last.
#pragma once

#include <algorithm>
#include <vector>

#include "core/mirror_planes.hpp"
#include "neighbours/grid.hpp"
#include "solid/bond_weight.hpp"

namespace kerf {

template <int D>
struct SolidLayout {
  std::vector<Medium<double>> media;
  std::vector<Vector<D, double>> reference;  // X, m
  std::vector<std::uint16_t> medium_index;   // per particle
  // Per medium, the body of which it is a level of resolution; empty: there are no levels.
  std::vector<std::uint16_t> body;
  MirrorPlanes<D> mirrors{};
};

// Lists in compressed rows: the bonds of i are neighbour[begin[i]] .. neighbour[begin[i + 1] - 1].
struct BondLists {
  std::vector<Index> begin, neighbour;
};

template <int D>
class BondFinder {
 public:
  explicit BondFinder(const SolidLayout<D>& layout) : layout_(layout) {
    const auto n = static_cast<Index>(layout.reference.size());
    for (const auto& medium : layout.media)
      reach_ = std::max(reach_, WendlandC2<D>::support * medium.smoothing_length);
    auto low = layout.reference.front(), high = low;
    for (const auto& x : layout.reference)
      for (int a = 0; a < D; ++a) {
        low[a] = std::min(low[a], x[a]);
        high[a] = std::max(high[a], x[a]);
      }
    grid_ = Grid<D>::covering(low, high, reach_, 4.0 * n + 64.0);
    cell_begin_.assign(grid_.count() + 1, 0);
    for (const auto& x : layout.reference) ++cell_begin_[grid_.number(x) + 1];
    for (Index c = 0; c < grid_.count(); ++c) cell_begin_[c + 1] += cell_begin_[c];
    std::vector<Index> next(cell_begin_.begin(), cell_begin_.end() - 1);
    member_.resize(n);
    for (Index i = 0; i < n; ++i) member_[next[grid_.number(layout.reference[i])]++] = i;
  }

  BondLists find() const {
    BondLists lists;
    lists.begin.push_back(0);
    for (Index i = 0; i < static_cast<Index>(layout_.reference.size()); ++i) {
      append_images(i, lists.neighbour);
      std::sort(lists.neighbour.begin() + lists.begin.back(), lists.neighbour.end());
      lists.begin.push_back(static_cast<Index>(lists.neighbour.size()));
    }
    return lists;
  }

 private:
  // Appends bonds to particles, and to mirror images where those are part of the same piece.
  void append_images(Index i, std::vector<Index>& neighbours) const {
    const auto& x = layout_.reference[i];
    const MirrorCode joined = layout_.media[layout_.medium_index[i]].joined_mirrors;
    for (int image = 0; image < MirrorPlanes<D>::images; ++image) {
      MirrorCode code;
      if (!layout_.mirrors.find_image(image, code) || (code & ~joined) != 0) continue;
      if (layout_.mirrors.is_near(code, x, reach_))
        append_bonds(i, code, layout_.mirrors.image_position(code, x), neighbours);
    }
  }

  // Appends the bonds in the cells around x, the position of i or of its image.
  void append_bonds(Index i, MirrorCode code, const Vector<D, double>& x,
                    std::vector<Index>& neighbours) const {
    int low[D], cells = 1;
    for (int a = 0; a < D; ++a) {
      low[a] = grid_.coordinate(x[a], a) - 1;
      cells *= 3;
    }
    for (int k = 0; k < cells; ++k) {
      int cell[D];
      bool inside = true;
      for (int a = 0, rest = k; a < D; ++a, rest /= 3) {
        cell[a] = low[a] + rest % 3;
        inside = inside && cell[a] >= 0 && cell[a] < grid_.cells[a];
      }
      if (!inside) continue;
      const Index c = grid_.number(cell);
      for (Index m = cell_begin_[c]; m < cell_begin_[c + 1]; ++m)
        if (is_bond(i, member_[m], code)) neighbours.push_back(member_[m] | code);
    }
  }

  bool is_bond(Index i, Index j, MirrorCode code) const {
    if (i == j && code == 0) return false;
    const double distance =
        norm(layout_.mirrors.separation(code, layout_.reference[i], layout_.reference[j]));
    const auto& a = layout_.media[layout_.medium_index[i]];
    const auto& b = layout_.media[layout_.medium_index[j]];
    return intact_weight<D>(a, b, distance) > 0.0;
  }

  const SolidLayout<D>& layout_;
  Grid<D> grid_{};
  double reach_ = 0.0;                      // m, of the longest bond
  std::vector<Index> cell_begin_, member_;  // particles of cell c: member_[cell_begin_[c]] ..
};

}  // namespace kerf
