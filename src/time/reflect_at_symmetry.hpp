// SPDX-License-Identifier: Apache-2.0
// This functor reflects fluid at symmetry planes. A fluid particle that has passed through a plane
// has met its mirror image there; the two have the same state, so that the particle continues as
// its image does. Solids are not reflected: contact with their mirror images holds them back.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct ReflectAtSymmetry {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  double dt;  // s, of the step

  KERF_FUNCTION void operator()(Index i) const {
    const auto& mirrors = particles.mirrors;
    if (mirrors.faces == 0 || !particles.is_fluid(i) || particles.is_constrained(i)) return;
    const auto& x = particles.position[i];
    MirrorCode passed = 0;
    for (int a = 0; a < D; ++a) {
      if (x[a] < mirrors.low[a]) passed |= mirrors.low_face(a);
      if (x[a] > mirrors.high[a]) passed |= mirrors.high_face(a);
    }
    passed &= mirrors.faces;
    if (passed == 0) return;
    const auto velocity = mirrors.image(passed, particles.velocity[i]);
    particles.mirror_acceleration[i] +=
        Real(1.0 / dt) * (velocity - particles.velocity[i]);  // for the balance of momentum
    particles.velocity[i] = velocity;
    particles.conservative_acceleration[i] =
        mirrors.image(passed, particles.conservative_acceleration[i]);
    particles.position[i] = mirrors.image_position(passed, x);
  }
};

}  // namespace kerf
