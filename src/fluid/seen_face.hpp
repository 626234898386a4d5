// SPDX-License-Identifier: Apache-2.0
// The face of a wall particle that a fluid particle sees. At the apex of a wedge the particle on
// the bisector of two faces is as far from the one as from the other: it has the mean n of both
// normals, which are n + c and n - c, c normal to n. The fluid on either side of the bisector sees
// the face of its side, so that a mirrored wall does the same to mirrored water; on the bisector it
// sees none.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

// Returns the normal of that face. `normal`: that of particle j, mirrored where the pair is;
// `separation`, m: of the fluid from j.
template <int D, class P>
KERF_FUNCTION Vector<D, typename P::Real> seen_face(const ParticleView<D, P>& particles, Index j,
                                                    const Vector<D, typename P::Real>& normal,
                                                    const Vector<D, typename P::Real>& separation) {
  using Real = typename P::Real;
  if constexpr (D == 2) {
    const Real corner = particles.face_corner[j];
    if (corner == Real(0)) return normal;
    constexpr Real least(1e-3);  // of the depth, within which rounding would decide
    const Vector<D, Real> half{-corner * normal[1], corner * normal[0]};
    const Real aside = dot(separation, half), depth = least * particles.face_depth[j];
    if (!(aside * aside > depth * depth * dot(half, half))) return Vector<D, Real>::zero();
    return aside > Real(0) ? normal + half : normal - half;
  }
  return normal;
}

}  // namespace kerf
