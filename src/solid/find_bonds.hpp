// SPDX-License-Identifier: Apache-2.0
// The bonds of the reference configuration, found once, on the host: a cell grid, then each
// particle's list in ascending order, so that every sum has one order for good.
#pragma once

#include <algorithm>
#include <vector>

#include "fracture/grady_kipp.hpp"
#include "kernels/wendland_c2.hpp"
#include "materials/plastic_law.hpp"
#include "neighbours/grid.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

template <int D>
struct SolidLayout {
  std::vector<SolidMedium<double>> media;
  std::vector<PlasticParameters<double>> plastic;  // per medium; empty: none flows
  std::vector<GradyKipp<double>> flaws;            // per medium; empty: none has flaws
  std::vector<Vector<D, double>> reference;        // X, m
  std::vector<std::uint16_t> medium_index;         // per particle
  // Per medium, the body of which it is a level of resolution; empty: there are no levels.
  std::vector<std::uint16_t> body;
};

// Lists in compressed rows: the bonds of i are neighbour[begin[i]] .. neighbour[begin[i + 1] - 1].
struct BondLists {
  std::vector<Index> begin, neighbour;
};

// w_ij of a whole bond (solid_fields.hpp), the same number in both directions; 0 where there is
// none.
template <int D, class T>
KERF_FUNCTION T whole_weight(const SolidMedium<T>& a, const SolidMedium<T>& b, T distance) {
  if (a.piece != b.piece) return T(0);
  const T h = T(0.5) * (a.smoothing_length + b.smoothing_length);
  return a.volume() * b.volume() * WendlandC2<D>::slope_per_distance(distance, h);
}

template <int D>
class BondFinder {
 public:
  explicit BondFinder(const SolidLayout<D>& layout) : layout_(layout) {
    const auto n = static_cast<Index>(layout.reference.size());
    double reach = 0.0;
    for (const auto& medium : layout.media)
      reach = std::max(reach, WendlandC2<D>::support * medium.smoothing_length);
    auto low = layout.reference.front(), high = low;
    for (const auto& x : layout.reference)
      for (int a = 0; a < D; ++a) {
        low[a] = std::min(low[a], x[a]);
        high[a] = std::max(high[a], x[a]);
      }
    grid_ = Grid<D>::covering(low, high, reach, 4.0 * n + 64.0);
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
      append_bonds(i, lists.neighbour);
      std::sort(lists.neighbour.begin() + lists.begin.back(), lists.neighbour.end());
      lists.begin.push_back(static_cast<Index>(lists.neighbour.size()));
    }
    return lists;
  }

 private:
  void append_bonds(Index i, std::vector<Index>& neighbours) const {
    int low[D], cells = 1;
    for (int a = 0; a < D; ++a) {
      low[a] = grid_.coordinate(layout_.reference[i][a], a) - 1;
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
        if (is_bond(i, member_[m])) neighbours.push_back(member_[m]);
    }
  }

  bool is_bond(Index i, Index j) const {
    if (i == j) return false;
    const double distance = norm(layout_.reference[i] - layout_.reference[j]);
    const auto& a = layout_.media[layout_.medium_index[i]];
    const auto& b = layout_.media[layout_.medium_index[j]];
    return whole_weight<D>(a, b, distance) > 0.0;
  }

  const SolidLayout<D>& layout_;
  Grid<D> grid_{};
  std::vector<Index> cell_begin_, member_;  // particles of cell c: member_[cell_begin_[c]] ..
};

}  // namespace kerf
