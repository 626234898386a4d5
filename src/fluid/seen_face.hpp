// SPDX-License-Identifier: Apache-2.0
// The face of a wall particle that a fluid particle sees. At the apex of a wedge the particle on
// the bisector of two faces is as far from the one as from the other: it has the mean n of both
// normals, which are n + c and n - c, c normal to n. The fluid on either side of the bisector sees
// the face of its side, so that a mirrored wall does the same to mirrored water; on the bisector it
// sees none.
#pragma once

#include "pairs/pair.hpp"

namespace kerf {

// Returns the normal of that face of particle j. `normal`, `corner`: n and c of j, mirrored where
// the pair is; `separation`, m: of the fluid from j.
template <int D, class P>
KERF_FUNCTION Vector<D, typename P::Real> seen_face(const ParticleView<D, P>& particles, Index j,
                                                    const Vector<D, typename P::Real>& normal,
                                                    const Vector<D, typename P::Real>& corner,
                                                    const Vector<D, typename P::Real>& separation) {
  using Real = typename P::Real;
  const Real square = dot(corner, corner);
  if (square == Real(0)) return normal;
  constexpr Real least(1e-3);  // of the depth, within which rounding would decide
  const Real aside = dot(separation, corner), depth = least * particles.face_depth[j];
  if (!(aside * aside > depth * depth * square)) return Vector<D, Real>::zero();
  return aside > Real(0) ? normal + corner : normal - corner;
}

// The same of the wall particle j of a pair with fluid.
template <int D, class P>
KERF_FUNCTION Vector<D, typename P::Real> seen_face(const ParticleView<D, P>& particles,
                                                    const Pair<D, P>& pair) {
  return seen_face(particles, pair.j, pair.of_j(particles.face_normal[pair.j]),
                   pair.of_j(particles.face_corner[pair.j]), pair.separation);
}
// The same of the wall particle i of a pair with fluid, at `separation`, m, from it.
template <int D, class P>
KERF_FUNCTION Vector<D, typename P::Real> seen_face(const ParticleView<D, P>& particles, Index i,
                                                    const Vector<D, typename P::Real>& separation) {
  return seen_face(particles, i, particles.face_normal[i], particles.face_corner[i], separation);
}

}  // namespace kerf
