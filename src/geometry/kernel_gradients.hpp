// SPDX-License-Identifier: Apache-2.0
// kernel_gradients() measures how unevenly points fill space, for the relaxation of layouts
// (docs/theory/layout.md).
#pragma once

#include <vector>

#include "geometry/cell_grid.hpp"
#include "kernels/wendland_c2.hpp"
#include "parallel/threads.hpp"

namespace kerf {

// The smoothing length of relaxations over the spacing, independent of that of the run.
inline constexpr double relaxing_smoothing_ratio = 1.3;
// The share of h^2 by which a step of a relaxation multiplies the sums.
inline constexpr double relaxing_share = 0.2;

// Returns sum_j V S_ij (x_j - x_i) = - sum_j V grad_i W_ij of the first `count` points, 1/m: it
// points to where points stand closer. `volume`: of a point, m^D; `h`: the smoothing length, m.
template <int D>
std::vector<Vector<D, double>> kernel_gradients(const std::vector<Vector<D, double>>& points,
                                                std::size_t count, double volume, double h) {
  const double reach = WendlandC2<D>::support * h;
  const CellGrid<D> grid(points, reach);
  std::vector<Vector<D, double>> sums(count, Vector<D, double>::zero());
  for_each_on_threads(static_cast<Index>(count), [&](Index i) {
    grid.visit_near(points[i], [&](std::size_t j) {
      const auto apart = points[j] - points[i];  // of itself: 0
      const double square = dot(apart, apart);
      if (square < reach * reach)
        sums[i] += (volume * WendlandC2<D>::slope_per_distance(std::sqrt(square), h)) * apart;
    });
  });
  return sums;
}

}  // namespace kerf
