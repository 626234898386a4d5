// SPDX-License-Identifier: Apache-2.0
// FacesBeside are the faces of smooth walls that look at a fluid particle. They take the reaction
// to what is added to its rates: rigid ones here, those of solids in fluid/wall_reaction.hpp.
#pragma once

#include <cstdint>

#include "fluid/facing_faces.hpp"

namespace kerf {

// What is completed of the rates of fluid beside smooth walls. Output needs the accelerations only,
// and leaves the rates of compression as the step has found them.
enum class WallCompletion : std::uint8_t { of_all_rates, of_accelerations };

template <int D, class P>
struct FacesBeside : FacingFaces<D, typename P::Real> {
  using Real = typename P::Real;
  using RealVector = Vector<D, Real>;
  Real rigid{}, mirrored{};  // 1/m, the parts of rigid faces and of images of others

  // Adds a face that looks at the fluid.
  KERF_FUNCTION void add_face(const FaceInFront<D, Real>& face, const Pair<D, P>& pair) {
    this->add(face);
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
