// SPDX-License-Identifier: Apache-2.0
// Symmetry planes of a cube [0, width]^D, and the complete problem of which a part is simulated:
// the part and its mirror images as explicit particles.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/mirror_planes.hpp"
#include "support/reference_sph.hpp"

namespace kerf::test {

// `faces`: such as "x- y+".
template <int D>
MirrorPlanes<D> planes_of(const std::string& faces, double width) {
  MirrorPlanes<D> planes{};
  for (int a = 0; a < D; ++a) {
    const char axis = static_cast<char>('x' + a);
    planes.low[a] = 0.0;
    planes.high[a] = width;
    if (faces.find({axis, '-'}) != std::string::npos) planes.faces |= planes.low_face(a);
    if (faces.find({axis, '+'}) != std::string::npos) planes.faces |= planes.high_face(a);
  }
  return planes;
}

// Returns the codes of all images, starting with that of the part itself (0).
template <int D>
std::vector<MirrorCode> images_of(const MirrorPlanes<D>& planes) {
  std::vector<MirrorCode> codes;
  for (int image = 0; image < MirrorPlanes<D>::images; ++image) {
    MirrorCode code;
    if (planes.find_image(image, code)) codes.push_back(code);
  }
  return codes;
}

// The same reflections, written independently; in whole_of() particle k of copy c has the number
// c n + k.
template <int D>
Vector3 mirrored_place(const MirrorPlanes<D>& planes, MirrorCode code, Vector3 x) {
  for (int a = 0; a < D; ++a) {
    if ((code & planes.low_face(a)) != 0) x[a] = 2.0 * planes.low[a] - x[a];
    if ((code & planes.high_face(a)) != 0) x[a] = 2.0 * planes.high[a] - x[a];
  }
  return x;
}
template <int D>
Vector3 mirrored_vector(const MirrorPlanes<D>& planes, MirrorCode code, Vector3 v) {
  for (int a = 0; a < D; ++a)
    if ((code & (planes.low_face(a) | planes.high_face(a))) != 0) v[a] = -v[a];
  return v;
}

// The images of pieces that are not joined to their images become separate pieces.
template <int D>
ReferenceState whole_of(const ReferenceState& part, const MirrorPlanes<D>& planes) {
  ReferenceState whole = part;
  whole.media.clear();
  whole.particles.clear();
  for (const MirrorCode code : images_of(planes)) {
    const std::size_t first_medium = whole.media.size();
    for (Medium<double> medium : part.media) {
      const auto images = images_of(planes);
      const auto apart = std::find(images.begin(), images.end(), code & ~medium.joined_mirrors);
      medium.piece = static_cast<std::uint16_t>(medium.piece + 100 * (apart - images.begin()));
      whole.media.push_back(medium);
    }
    for (ReferenceParticle particle : part.particles) {
      particle.position = mirrored_place(planes, code, particle.position);
      particle.velocity = mirrored_vector(planes, code, particle.velocity);
      particle.source += first_medium;
      whole.particles.push_back(particle);
    }
  }
  return whole;
}

}  // namespace kerf::test
