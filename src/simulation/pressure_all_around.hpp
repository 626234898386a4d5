// SPDX-License-Identifier: Apache-2.0
// A pressure on the whole surface of a body acts on the area vectors that the sums of the solid
// imply (solid/area_vectors.hpp): it neither moves nor turns the body and leaves a uniform stress
// in it, whatever its shape and however it lies to the lattice.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulation/face_sharing.hpp"
#include "solid/area_vectors.hpp"

namespace kerf {

// The surface of a body in its particles.
template <int D>
class SurfaceParticles {
 public:
  struct Area {
    std::uint32_t id;
    std::uint32_t bearer;    // id of the particle that has the face, mostly itself
    Vector<D, double> area;  // m^2 (2D: m), outward
  };

  // `chosen`: the particles of the body, not empty; `surface` by the `number` of each in the solid.
  SurfaceParticles(const SurfaceOfSolid<D>& surface, const std::vector<SharingParticle<D>>& chosen,
                   const std::vector<std::uint32_t>& number) {
    auto left_out = Vector<D, double>::zero();
    double sum = 0.0, coarsest = 0.0;
    for (const SharingParticle<D>& particle : chosen) {
      const Vector<D, double>& area = surface.area[number[particle.id]];
      if (norm(area) <= rounding * std::pow(particle.spacing, D - 1)) {
        left_out += area;
        continue;
      }
      areas_.push_back({particle.id, particle.id, area});
      position_.push_back(particle.position);
      sum += norm(area);
      coarsest = std::max(coarsest, particle.spacing);
    }
    for (Area& of : areas_) of.area += (norm(of.area) / sum) * left_out;
    if (!areas_.empty()) find_bearers(two_rows * coarsest);
  }

  const std::vector<Area>& areas() const { return areas_; }

 private:
  static constexpr double rounding = 1e-5;  // of the face of a particle, of particles inside
  static constexpr double two_rows = 2.3;   // spacings

  // The rows behind the outermost one have small areas of the opposite sense, which are only there
  // as long as it is.
  void find_bearers(double within) {
    sort_into_cells(within);
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      double most = norm(areas_[i].area);
      for_each_near(position_[i], within, [&](std::size_t j) {
        if (dot(areas_[i].area, areas_[j].area) >= 0.0 || norm(areas_[j].area) <= most) return;
        most = norm(areas_[j].area);
        areas_[i].bearer = areas_[j].id;
      });
    }
  }

  void sort_into_cells(double width) {
    auto low = position_.front(), high = low;
    for (const auto& x : position_)
      for (int a = 0; a < D; ++a) {
        low[a] = std::min(low[a], x[a]);
        high[a] = std::max(high[a], x[a]);
      }
    grid_ = Grid<D>::covering(low, high, width, 4.0 * static_cast<double>(areas_.size()) + 64.0);
    cells_.resize(grid_.count());
    for (std::size_t k = 0; k < areas_.size(); ++k) cells_[grid_.number(position_[k])].push_back(k);
  }

  // Calls visit(k) for those nearer to x than `within`, the width of the cells.
  template <class Visit>
  void for_each_near(const Vector<D, double>& x, double within, const Visit& visit) const {
    const int cells = D == 3 ? 27 : 9;
    for (int k = 0; k < cells; ++k) {
      int cell[D];
      bool inside = true;
      for (int a = 0, rest = k; a < D; ++a, rest /= 3) {
        cell[a] = grid_.coordinate(x[a], a) - 1 + rest % 3;
        inside = inside && cell[a] >= 0 && cell[a] < grid_.cells[a];
      }
      if (!inside) continue;
      for (const std::size_t found : cells_[grid_.number(cell)])
        if (norm(position_[found] - x) < within) visit(found);
    }
  }

  std::vector<Area> areas_;
  std::vector<Vector<D, double>> position_;  // m, of each of them
  Grid<D> grid_;
  std::vector<std::vector<std::size_t>> cells_;
};

// Returns whether one of these particles is bonded to another body: the solid has no surface there,
// though the body has.
template <int D>
bool is_joined(const SurfaceOfSolid<D>& surface, const std::vector<SharingParticle<D>>& chosen,
               const std::vector<std::uint32_t>& number) {
  return std::any_of(chosen.begin(), chosen.end(),
                     [&](const auto& of) { return surface.joined[number[of.id]] != 0; });
}

}  // namespace kerf
