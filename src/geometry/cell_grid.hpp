// SPDX-License-Identifier: Apache-2.0
// A grid of cells over a set of points, for the search of those near a position.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/vector.hpp"

namespace kerf {

template <int D>
class CellGrid {
 public:
  using Position = Vector<D, double>;

  // Sorts the points (m) into cells of `width` (m), which keep them in order of their numbers.
  CellGrid(const std::vector<Position>& points, double width) : width_(width) {
    size_.fill(0);
    if (points.empty()) return;
    find_extent(points);
    std::size_t count = 1;
    for (const std::int64_t size : size_) count *= static_cast<std::size_t>(size);
    begin_.assign(count + 1, 0);
    for (const Position& x : points) ++begin_[index_of(cell_of(x)) + 1];
    for (std::size_t c = 0; c < count; ++c) begin_[c + 1] += begin_[c];
    items_.resize(points.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      items_[next[index_of(cell_of(points[i]))]++] = i;
  }

  // Calls visit(number) for the points in the cell of x and in those beside it: all that are nearer
  // than a `width`, and others.
  template <class Visit>
  void visit_near(const Position& x, const Visit& visit) const {
    const Cell middle = cell_of(x);
    for (std::size_t a = 0; a < D; ++a)
      if (middle[a] < -1 || middle[a] > size_[a]) return;
    for (int k = 0; k < (D == 2 ? 9 : 27); ++k) {
      Cell beside = middle;
      bool is_inside = true;
      for (std::size_t a = 0, rest = static_cast<std::size_t>(k); a < D; ++a, rest /= 3) {
        beside[a] += static_cast<std::int64_t>(rest % 3) - 1;
        is_inside = is_inside && beside[a] >= 0 && beside[a] < size_[a];
      }
      if (!is_inside) continue;
      const std::size_t c = index_of(beside);
      for (std::size_t n = begin_[c]; n < begin_[c + 1]; ++n) visit(items_[n]);
    }
  }

 private:
  using Cell = std::array<std::int64_t, D>;

  void find_extent(const std::vector<Position>& points) {
    Position highest = points.front();
    lowest_ = points.front();
    for (const Position& x : points)
      for (int a = 0; a < D; ++a) {
        lowest_[a] = std::min(lowest_[a], x[a]);
        highest[a] = std::max(highest[a], x[a]);
      }
    const Cell last = cell_of(highest);
    for (std::size_t a = 0; a < D; ++a) size_[a] = last[a] + 1;
  }
  Cell cell_of(const Position& x) const {
    Cell cell;
    for (int a = 0; a < D; ++a)
      cell[static_cast<std::size_t>(a)] =
          static_cast<std::int64_t>(std::floor((x[a] - lowest_[a]) / width_));
    return cell;
  }
  std::size_t index_of(const Cell& cell) const {
    std::int64_t index = 0;
    for (std::size_t a = D; a-- > 0;) index = index * size_[a] + cell[a];
    return static_cast<std::size_t>(index);
  }

  double width_;  // m
  Position lowest_ = Position::zero();
  std::array<std::int64_t, D> size_;  // cells along each axis
  std::vector<std::size_t> begin_;    // of each cell in items_
  std::vector<std::size_t> items_;
};

}  // namespace kerf
