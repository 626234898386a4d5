// SPDX-License-Identifier: Apache-2.0
// The symmetry planes of a run, and which pieces of solid are laid out at them.
#pragma once

#include <cmath>
#include <vector>

#include "case/case.hpp"
#include "core/mirror_planes.hpp"
#include "particles/medium.hpp"
#include "simulation/populate.hpp"

namespace kerf {

template <int D>
MirrorPlanes<D> mirror_planes(const Case& description) {
  MirrorPlanes<D> mirrors{};
  mirrors.low = Vector<D, double>::from(description.domain.minimum);
  mirrors.high = Vector<D, double>::from(description.domain.maximum);
  for (int a = 0; a < D; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    if (description.symmetry.minimum[axis]) mirrors.faces |= mirrors.low_face(a);
    if (description.symmetry.maximum[axis]) mirrors.faces |= mirrors.high_face(a);
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

// A piece that has particles within 3/4 of a spacing of a plane - half a spacing is that of a face
// in the plane - is one with its mirror image.
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
