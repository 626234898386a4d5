// SPDX-License-Identifier: Apache-2.0
// KeepContactEnergy records what the contacts of a particle of solid hold in a step, so that the
// balance can tell what is released if the particle becomes detached in the next one
// (standard/solid_link.hpp). The potential of a contact between two solids is counted half for each
// of the two and ends for both; that with a rigid body is the solid's alone. Where both particles
// become detached in one step, their contact is counted twice.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct KeepContactEnergy {
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    if (medium.phase != Phase::solid) return;
    using Real = typename P::Real;
    particles.contact_energy[i] = Real(2) * particles.repulsion_potential[i] -
                                  particles.rigid_contact[i].energy / medium.mass;
  }
};

}  // namespace kerf
