// SPDX-License-Identifier: Apache-2.0
// This functor records the state of a particle at the start of a step, from which the integrators
// (time/verlet.hpp, shinohara2004/midpoint.hpp) set out.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct SaveStepStart {
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    particles.start_position[i] = particles.position[i];
    particles.start_velocity[i] = particles.velocity[i];
    particles.start_compression[i] = particles.compression[i];
    if (particles.shear == nullptr) return;
    particles.start_shear[i] = particles.shear[i];
    particles.fracture_loss[i] = typename P::Real(0);
  }
};

}  // namespace kerf
