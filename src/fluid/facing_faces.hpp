// SPDX-License-Identifier: Apache-2.0
// The faces of a smooth wall that look at a fluid particle, and sums over them. The pair of the
// particle i with a particle j of the wall counts by its weight a = V_j S_ij d_ij . n_j, 1/m; the
// foot of j is the point of the surface nearest to it.
#pragma once

#include "fluid/seen_face.hpp"
#include "pairs/pair.hpp"

namespace kerf {

// The face of a particle j of a smooth wall, as a fluid particle i sees it.
template <int D, class Real>
struct FaceInFront {
  Vector<D, Real> normal, foot;  // the foot relative to i, m
  Real depth;                    // m, of j below its face
  Real along, height;  // m, of i above j along the normal, and above the plane of the face
  Real weight;         // 1/m

  template <class P>
  KERF_FUNCTION static FaceInFront of(const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
    const auto normal_j = seen_face(particles, pair);
    const Real depth_j = particles.face_depth[pair.j], along_j = dot(pair.separation, normal_j);
    return {normal_j,          depth_j * normal_j - pair.separation,
            depth_j,           along_j,
            along_j - depth_j, pair.medium_j->volume * pair.slope_per_distance * along_j};
  }
  KERF_FUNCTION bool looks_at_fluid() const { return height > Real(0); }
};

// Sums over such faces.
template <int D, class Real>
struct FacingFaces {
  Vector<D, Real> normal{};  // 1/m, sum a n_j
  Vector<D, Real> foot{};    // 1, sum a foot_j
  Real all{};                // 1/m, sum a
  Real height{};             // 1, sum a s_j, with the height s_j of i above the plane of j

  KERF_FUNCTION void add(const FaceInFront<D, Real>& face) {
    normal += face.weight * face.normal;
    foot += face.weight * face.foot;
    all += face.weight;
    height += face.weight * face.height;
  }
  // Returns by how much the centroid of the feet lies aside of i, m, given the normal of the wall.
  KERF_FUNCTION Real aside(const Vector<D, Real>& n) const {
    const Vector<D, Real> centroid = (Real(1) / all) * foot;
    return norm(centroid - dot(centroid, n) * n);
  }
};

}  // namespace kerf
