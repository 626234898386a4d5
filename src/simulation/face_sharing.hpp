// SPDX-License-Identifier: Apache-2.0
// How the particles at a face of a body share it. The face comes in elements whose areas add up to
// its area (geometry/surface_elements.hpp); each is shared among the particles near it, by weights
// that sum to 1. So the shares add up to the face, however it lies to the lattice.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "neighbours/grid.hpp"

namespace kerf {

template <int D>
struct SharingParticle {
  std::uint32_t id = 0;
  Vector<D, double> position;  // m, at the start
  double spacing = 0.0;        // m
};

template <int D>
class FaceSharing {
 public:
  // `particles`: of the body, in the order of their ids; not empty.
  explicit FaceSharing(std::vector<SharingParticle<D>> particles)
      : particles_(std::move(particles)) {
    auto low = particles_.front().position, high = low;
    double farthest = 0.0;
    for (const auto& particle : particles_) {
      for (int a = 0; a < D; ++a) {
        low[a] = std::min(low[a], particle.position[a]);
        high[a] = std::max(high[a], particle.position[a]);
      }
      farthest = std::max(farthest, reach(particle));
    }
    const auto count = static_cast<double>(particles_.size());
    grid_ = Grid<D>::covering(low, high, farthest, 4.0 * count + 64.0);
    cells_.resize(grid_.count());
    for (std::size_t k = 0; k < particles_.size(); ++k)
      cells_[grid_.number(particles_[k].position)].push_back(k);
  }

  // Of a face along the lattice only the outermost layer, half a spacing below it, is in reach. In
  // a graded body each particle has the reach of its own spacing.
  static double reach(const SharingParticle<D>& particle) { return 1.5 * particle.spacing; }

  // Calls visit(id, weight) for the particles near an element: 1 - r / reach, over the sum of all.
  // `places`: the middle of the element, and its mirror images where the row is to go on beyond an
  // end; a particle near several is visited for each.
  template <class Visit>
  void share(std::span<const Vector<D, double>> places, const Visit& visit) const {
    double sum = 0.0;
    for (const auto& x : places) near(x, [&](std::uint32_t, double weight) { sum += weight; });
    if (!(sum > 0.0)) return visit(nearest(places.front()), 1.0);
    for (const auto& x : places)
      near(x, [&](std::uint32_t id, double weight) { visit(id, weight / sum); });
  }

 private:
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
      if (inside) visit_cell(cells_[grid_.number(cell)], x, visit);
    }
  }
  template <class Visit>
  void visit_cell(const std::vector<std::size_t>& cell, const Vector<D, double>& x,
                  const Visit& visit) const {
    for (const std::size_t k : cell) {
      const double weight = 1.0 - norm(particles_[k].position - x) / reach(particles_[k]);
      if (weight > 1e-9) visit(particles_[k].id, weight);
    }
  }
  std::uint32_t nearest(const Vector<D, double>& x) const {
    const auto found = std::min_element(particles_.begin(), particles_.end(),
                                        [&](const auto& one, const auto& other) {
                                          return norm(one.position - x) < norm(other.position - x);
                                        });
    return found->id;
  }

  std::vector<SharingParticle<D>> particles_;
  Grid<D> grid_;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace kerf
