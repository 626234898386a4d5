// SPDX-License-Identifier: Apache-2.0
// Shares the force of an element of a loaded face among the particles near it, by weights that sum
// to 1: so the force is traction times area, however the face lies to the lattice.
#pragma once

#include <algorithm>
#include <vector>

#include "core/vector.hpp"
#include "neighbours/grid.hpp"

namespace kerf {

// The initial particles of a body, found by position.
template <int D>
class BodyParticles {
 public:
  // `chosen`: ids; not empty. `spacing` of the coarsest, m.
  BodyParticles(const std::vector<Vector<D, double>>& position, std::vector<std::uint32_t> chosen,
                double spacing)
      : position_(position), chosen_(std::move(chosen)), spacing_(spacing) {
    auto low = position[chosen_.front()], high = low;
    for (const std::uint32_t id : chosen_)
      for (int a = 0; a < D; ++a) {
        low[a] = std::min(low[a], position[id][a]);
        high[a] = std::max(high[a], position[id][a]);
      }
    grid_ = Grid<D>::covering(low, high, reach(), 4.0 * static_cast<double>(chosen_.size()) + 64.0);
    cells_.resize(grid_.count());
    for (const std::uint32_t id : chosen_) cells_[grid_.number(position[id])].push_back(id);
  }

  // Calls visit(id, weight) for the particles near x: 1 - r / reach, over the sum of all.
  template <class Visit>
  void share(const Vector<D, double>& x, const Visit& visit) const {
    double sum = 0.0;
    near(x, [&](std::uint32_t, double weight) { sum += weight; });
    if (sum > 0.0)
      near(x, [&](std::uint32_t id, double weight) { visit(id, weight / sum); });
    else
      visit(nearest(x), 1.0);
  }

 private:
  // Of a face along the lattice only the outermost layer, half a spacing below it, is in reach.
  double reach() const { return 1.5 * spacing_; }

  template <class Visit>
  void near(const Vector<D, double>& x, const Visit& visit) const {
    int first[D], cells = 1;
    for (int a = 0; a < D; ++a) {
      first[a] = grid_.coordinate(x[a], a) - 1;
      cells *= 3;
    }
    for (int k = 0; k < cells; ++k) {
      int cell[D];
      bool inside = true;
      for (int a = 0, rest = k; a < D; ++a, rest /= 3) {
        cell[a] = first[a] + rest % 3;
        inside = inside && cell[a] >= 0 && cell[a] < grid_.cells[a];
      }
      if (!inside) continue;
      for (const std::uint32_t id : cells_[grid_.number(cell)]) {
        const double weight = 1.0 - norm(position_[id] - x) / reach();
        if (weight > 1e-9) visit(id, weight);
      }
    }
  }
  std::uint32_t nearest(const Vector<D, double>& x) const {
    return *std::min_element(chosen_.begin(), chosen_.end(), [&](auto i, auto j) {
      return norm(position_[i] - x) < norm(position_[j] - x);
    });
  }

  const std::vector<Vector<D, double>>& position_;
  std::vector<std::uint32_t> chosen_;
  double spacing_;
  Grid<D> grid_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace kerf
