// SPDX-License-Identifier: Apache-2.0
// The fracture test at the end of a step: a solid particle whose equivalent strain exceeds its
// material's failure strain loses its shear and from then on bears compression only. The shear
// energy it gives up is booked; what it did against pressure stays in its pressure work.
#pragma once

#include "fracture/equivalent_strain.hpp"
#include "materials/hooke_solid.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct BreakParticles {
  using Real = typename P::Real;
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    if (medium.phase != Phase::solid || particles.fractured[i]) return;
    if (!(medium.failure_strain > Real(0))) return;
    const auto& s = particles.shear[i];
    if (!(equivalent_strain(s, medium.shear_modulus) > medium.failure_strain)) return;
    const double compression = particles.compression[i];
    const double released = HookeSolid::deviatoric_energy(medium, s, compression);
    particles.fracture_loss[i] = static_cast<Real>(medium.mass * released);
    particles.fractured[i] = 1;
    particles.shear[i] = SymmetricTensor<D, Real>::zero();
  }
};

}  // namespace kerf
