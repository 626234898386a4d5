// SPDX-License-Identifier: Apache-2.0
// The symmetry planes of a run, and the pieces of solid that are joined to their mirror images.
#pragma once

#include <cmath>
#include <vector>

#include "core/mirror_planes.hpp"
#include "model/medium.hpp"
#include "simulation/run_settings.hpp"

namespace kerf {

template <int D>
MirrorPlanes<D> mirror_planes(const RunSettings& settings) {
  MirrorPlanes<D> mirrors{};
  mirrors.low = Vector<D, double>::from(settings.domain_minimum);
  mirrors.high = Vector<D, double>::from(settings.domain_maximum);
  for (int a = 0; a < D; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    if (settings.mirror_minimum[axis]) mirrors.faces |= mirrors.low_face(a);
    if (settings.mirror_maximum[axis]) mirrors.faces |= mirrors.high_face(a);
  }
  return mirrors;
}

template <int D>
std::vector<MirrorCode> single_planes(const MirrorPlanes<D>& mirrors) {
  std::vector<MirrorCode> planes;
  for (int a = 0; a < D; ++a)
    for (const MirrorCode face : {mirrors.low_face(a), mirrors.high_face(a)})
      if ((face & mirrors.faces) != 0) planes.push_back(face);
  return planes;
}

// Joins to its mirror image each piece that has particles within 3/4 of a spacing of a plane; half
// a spacing is the distance of a face in the plane.
template <int D>
void join_mirrors(const MirrorPlanes<D>& mirrors, const std::vector<NewParticle>& particles,
                  std::vector<Medium<double>>& media) {
  constexpr double near = 0.75;
  std::vector<MirrorCode> joined(media.size() + 1, 0);  // per piece
  for (const NewParticle& particle : particles) {
    const Medium<double>& medium = media[particle.source];
    if (medium.phase != Phase::solid) continue;
    const auto x = Vector<D, double>::from(particle.position);
    for (const MirrorCode face : single_planes(mirrors))
      if (mirrors.is_near(face, x, near * medium.spacing)) joined[medium.piece] |= face;
  }
  for (Medium<double>& medium : media)
    if (medium.phase == Phase::solid) medium.joined_mirrors = joined[medium.piece];
}

}  // namespace kerf
