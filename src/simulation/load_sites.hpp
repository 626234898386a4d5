// SPDX-License-Identifier: Apache-2.0
// The particles that the loads of a case act on and their shares. The loaded face is the part of
// the surface of the body that lies in the region of the load, in elements whose areas add up to
// its area (geometry/surface_elements.hpp). Each element is shared among the particles near it, by
// weights that sum to 1: so the force is traction times area, however the face lies to the lattice.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "core/error.hpp"
#include "model/medium.hpp"
#include "neighbours/grid.hpp"
#include "simulation/run_settings.hpp"
#include "solid/body_load.hpp"

namespace kerf {

template <int D>
struct LoadLayout {
  std::vector<LoadSite<D>> sites;
  std::vector<LoadShare<D>> shares;
};

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

// Collects the shares of particles.
template <int D>
class LoadShares {
 public:
  // Adds a force to the share of a load in a particle.
  void add(std::uint32_t id, const LoadShare<D>& share) {
    auto& shares = of_particle_[id];
    if (shares.empty() || shares.back().load != share.load)
      shares.push_back(share);
    else
      shares.back().full += share.full;
  }
  // `number` of each particle in the solid, whose order the sites have.
  LoadLayout<D> layout(const std::vector<Medium<double>>& media,
                       const std::vector<std::uint16_t>& source,
                       const std::vector<std::uint32_t>& number) const {
    LoadLayout<D> result;
    for (const auto& [id, shares] : of_particle_) {
      const auto first = static_cast<Index>(result.shares.size());
      result.shares.insert(result.shares.end(), shares.begin(), shares.end());
      result.sites.push_back({number[id], first, static_cast<Index>(result.shares.size()),
                              media[source[id]].mass, Vector<D, double>::zero()});
    }
    return result;
  }

 private:
  std::map<std::uint32_t, std::vector<LoadShare<D>>> of_particle_;  // by id
};

// Returns the sites of all loads. `position` and `source` of the initial particles, by their ids;
// `number` of each in the solid; `detached` by that number. Particles that are detached from the
// start, such as single ones at the tip of a wedge, take no part of a face.
template <int D>
LoadLayout<D> load_sites(const RunSettings& settings, const std::vector<Medium<double>>& media,
                         const std::vector<Vector<D, double>>& position,
                         const std::vector<std::uint16_t>& source,
                         const std::vector<std::uint32_t>& number,
                         const std::vector<std::uint8_t>& detached) {
  LoadShares<D> shares;
  for (std::uint32_t n = 0; n < settings.loads.size(); ++n) {
    const RunLoad& load = settings.loads[n];
    std::vector<std::uint32_t> chosen;
    double coarsest = 0.0;
    for (std::uint32_t id = 0; id < position.size(); ++id) {
      if (settings.origins[source[id]].source != load.source || detached[number[id]] != 0) continue;
      chosen.push_back(id);
      coarsest = std::max(coarsest, media[source[id]].spacing);
    }
    const auto acceleration = Vector<D, double>::from(load.acceleration);
    for (const std::uint32_t id : load.particles)
      shares.add(id, {n, false, false, media[source[id]].mass * acceleration});
    if (chosen.empty() || load.faces.empty()) continue;
    const BodyParticles<D> particles(position, std::move(chosen), coarsest);
    for (const LoadedElement& element : load.faces) {
      const auto force = Vector<D, double>::from(element.force);
      particles.share(Vector<D, double>::from(element.position),
                      [&](std::uint32_t id, double weight) {
                        shares.add(id, {n, true, load.follows, weight * force});
                      });
    }
  }
  return shares.layout(media, source, number);
}

}  // namespace kerf
