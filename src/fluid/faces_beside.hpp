// SPDX-License-Identifier: Apache-2.0
// FacesBeside are the faces of smooth walls that look at a fluid particle. They take the reaction
// to what is added to its rates: rigid ones here, those of solids in fluid/wall_reaction.hpp.
#pragma once

#include "fluid/smooth_wall.hpp"

namespace kerf {

// The face of a particle j of a smooth wall, as a fluid particle i sees it.
template <int D, class Real>
struct FaceInFront {
  Vector<D, Real> normal;
  Real depth, height;  // m, of j below it, of i above its plane
  Real weight;         // 1/m, a_j = V_j S_ij d_ij . n_j

  template <class P>
  KERF_FUNCTION static FaceInFront of(const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
    const auto normal_j = pair.of_j(particles.face_normal[pair.j]);
    const Real depth_j = particles.face_depth[pair.j], along = dot(pair.separation, normal_j);
    return {normal_j, depth_j, along - depth_j,
            pair.medium_j->volume * pair.slope_per_distance * along};
  }
  KERF_FUNCTION bool looks_at_fluid() const { return height > Real(0); }
};

template <int D, class P>
struct FacesBeside : FacingFaces<D, typename P::Real> {
  using Real = typename P::Real;
  using RealVector = Vector<D, Real>;
  Real rigid{}, mirrored{};  // 1/m, the parts of rigid faces and of images of others

  // Adds a face that looks at the fluid.
  KERF_FUNCTION void add_face(const FaceInFront<D, Real>& face, const Pair<D, P>& pair) {
    this->add(face.weight, face.normal, face.depth * face.normal - pair.separation, face.height);
    if (pair.medium_j->phase == Phase::rigid)
      rigid += face.weight;
    else if (pair.mirror != 0)
      mirrored += face.weight;
  }
  // Accelerates the fluid particle i at the cost of the faces.
  KERF_FUNCTION void push(const ParticleView<D, P>& particles, Index i,
                          const RealVector& acceleration) const {
    particles.pressure_acceleration[i] += acceleration;
    particles.acceleration[i] += acceleration;
    const Real inverse = Real(1) / this->all;
    particles.repulsion[i] += inverse * rigid * acceleration;
    if (particles.mirrors.faces != 0)
      particles.mirror_acceleration[i] += inverse * mirrored * acceleration;
    auto& given = particles.wall_push[i];
    given = {given.acceleration + acceleration, inverse};
  }
};

}  // namespace kerf
