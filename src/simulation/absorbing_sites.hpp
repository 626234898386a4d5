// SPDX-License-Identifier: Apache-2.0
// The particles at the absorbing faces of bodies and their rates of damping. The elements of a face
// are shared among the particles near it (simulation/face_sharing.hpp), so that the areas of the
// sites add up to that of the face, however it lies to the lattice.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "model/medium.hpp"
#include "simulation/face_sharing.hpp"
#include "simulation/run_settings.hpp"
#include "solid/absorbing_boundary.hpp"

namespace kerf {

// The initial particles that may be sites, by their ids.
template <int D>
struct AbsorbingCandidates {
  const RunSettings& settings;
  const std::vector<Medium<double>>& media;
  const std::vector<Vector<D, double>>& position;
  const std::vector<std::uint16_t>& source;
  const std::vector<std::uint32_t>& number;   // of each in the solid
  const std::vector<std::uint8_t>& detached;  // by that number; empty: none

  bool is_detached(std::uint32_t id) const {
    return !detached.empty() && detached[number[id]] != 0;
  }
  // Returns those of the body of a side that reach its face.
  std::vector<SharingParticle<D>> at(const AbsorbingSide& side) const {
    std::vector<SharingParticle<D>> chosen;
    if (side.elements.empty()) return chosen;
    const double face = side.elements.front().position[static_cast<std::size_t>(side.axis)];
    for (std::uint32_t id = 0; id < position.size(); ++id) {
      if (settings.origins[source[id]].source != side.source || is_detached(id)) continue;
      const SharingParticle<D> particle{id, position[id], media[source[id]].spacing};
      if (std::abs(position[id][side.axis] - face) < FaceSharing<D>::reach(particle))
        chosen.push_back(particle);
    }
    return chosen;
  }
};

// Returns the middle of an element and its mirror images in the edges of the face that are in
// reach: there the rows behind a face go on, and each particle of a row gets the same area.
template <int D>
std::vector<Vector<D, double>> with_images(const AbsorbingSide& side,
                                           const AbsorbingElement& element, double reach) {
  std::vector<Vector<D, double>> places{Vector<D, double>::from(element.position)};
  for (int a = 0; a < D; ++a) {
    if (a == side.axis) continue;
    const auto axis = static_cast<std::size_t>(a);
    const std::size_t count = places.size();
    for (const double edge : {side.edges.minimum[axis], side.edges.maximum[axis]}) {
      if (std::abs(element.position[axis] - edge) > reach) continue;
      for (std::size_t k = 0; k < count; ++k) {
        places.push_back(places[k]);
        places.back()[a] = 2.0 * edge - element.position[axis];
      }
    }
  }
  return places;
}

// Returns the area of each particle, by id, in the face of a side.
template <int D>
std::map<std::uint32_t, double> areas_in(const AbsorbingSide& side,
                                         std::vector<SharingParticle<D>> particles) {
  std::map<std::uint32_t, double> area_of;
  if (particles.empty()) return area_of;
  double reach = 0.0;
  for (const auto& particle : particles) reach = std::max(reach, FaceSharing<D>::reach(particle));
  const FaceSharing<D> sharing(std::move(particles));
  for (const AbsorbingElement& element : side.elements) {
    const auto places = with_images<D>(side, element, reach);
    sharing.share(places,
                  [&](std::uint32_t id, double weight) { area_of[id] += weight * element.area; });
  }
  return area_of;
}

// Returns the sites of all absorbing sides. The damping of t = - rho c_p v_n n - rho c_s v_t on the
// area A of a particle of mass m has the rate rho c A / m along each axis, summed over the faces
// that the particle has a part of. Particles that are detached take no part.
template <int D>
std::vector<AbsorbingSite<D>> absorbing_sites(const AbsorbingCandidates<D>& candidates) {
  std::map<std::uint32_t, Vector<D, double>> rate_of;  // by id
  for (const AbsorbingSide& side : candidates.settings.absorbing) {
    for (const auto& [id, area] : areas_in<D>(side, candidates.at(side))) {
      const Medium<double>& medium = candidates.media[candidates.source[id]];
      const double shear_speed = std::sqrt(medium.shear_modulus / medium.density);
      auto& rate = rate_of.try_emplace(id, Vector<D, double>::zero()).first->second;
      for (int a = 0; a < D; ++a)
        rate[a] += (a == side.axis ? medium.longitudinal_speed : shear_speed) * area *
                   medium.density / medium.mass;
    }
  }
  std::vector<AbsorbingSite<D>> sites;
  for (const auto& [id, rate] : rate_of)
    sites.push_back({candidates.number[id], candidates.media[candidates.source[id]].mass, rate,
                     Vector<D, double>::zero()});
  return sites;
}

}  // namespace kerf
