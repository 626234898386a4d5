// SPDX-License-Identifier: Apache-2.0
// The particles that the loads of a case act on and their shares. The loaded face is the part of
// the surface of the body that lies in the region of the load, in elements whose areas add up to
// its area (geometry/surface_elements.hpp). Each element is shared among the particles near it
// (simulation/face_sharing.hpp); a pressure all around acts on the area vectors of the solid
// instead (simulation/pressure_all_around.hpp).
#pragma once

#include <map>
#include <vector>

#include "model/medium.hpp"
#include "simulation/face_sharing.hpp"
#include "simulation/pressure_all_around.hpp"
#include "simulation/run_settings.hpp"
#include "solid/body_load.hpp"

namespace kerf {

template <int D>
struct LoadLayout {
  std::vector<LoadSite<D>> sites;
  std::vector<LoadShare<D>> shares;
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
// `number` of each in the solid; `surface` by that number. Particles that are detached from the
// start, such as single ones at the tip of a wedge, take no part of a face.
template <int D>
LoadLayout<D> load_sites(const RunSettings& settings, const std::vector<Medium<double>>& media,
                         const std::vector<Vector<D, double>>& position,
                         const std::vector<std::uint16_t>& source,
                         const std::vector<std::uint32_t>& number,
                         const SurfaceOfSolid<D>& surface) {
  LoadShares<D> shares;
  for (std::uint32_t n = 0; n < settings.loads.size(); ++n) {
    const RunLoad& load = settings.loads[n];
    std::vector<SharingParticle<D>> chosen;
    for (std::uint32_t id = 0; id < position.size(); ++id) {
      if (settings.origins[source[id]].source != load.source) continue;
      if (surface.detached[number[id]] != 0) continue;
      chosen.push_back({id, position[id], media[source[id]].spacing});
    }
    const auto acceleration = Vector<D, double>::from(load.acceleration);
    for (const std::uint32_t id : load.particles)
      shares.add(id, {n, number[id], false, false, media[source[id]].mass * acceleration});
    if (chosen.empty() || load.faces.empty()) continue;
    if (load.is_all_around && !is_joined(surface, chosen, number)) {
      const SurfaceParticles<D> face(surface, chosen, number);
      for (const auto& [id, bearer, area] : face.areas())
        shares.add(id, {n, number[bearer], true, true, -load.pressure * area});
      continue;
    }
    const FaceSharing<D> particles(std::move(chosen));
    for (const LoadedElement& element : load.faces) {
      const auto force = Vector<D, double>::from(element.force);
      const auto x = Vector<D, double>::from(element.position);
      particles.share({&x, 1}, [&](std::uint32_t id, double weight) {
        shares.add(id, {n, number[id], true, load.follows, weight * force});
      });
    }
  }
  return shares.layout(media, source, number);
}

}  // namespace kerf
