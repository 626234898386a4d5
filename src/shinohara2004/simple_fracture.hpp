// SPDX-License-Identifier: Apache-2.0
// Instantaneous simple fracture, section 2.3 of Shinohara et al. (2004): a particle fractures when
// the equivalent strain of its principal elastic strains,
//   (sqrt(2)/3) sqrt[(e1-e2)^2 + (e2-e3)^2 + (e3-e1)^2],
// exceeds the failure strain of its material. The pressure part of the strain is the same on every
// axis and drops out of the differences, and for the deviatoric part e' = s/2G the bracket is
// 3 e':e', so that the equivalent strain is sqrt(2/3 e':e') = sqrt(2/3 s:s) / 2G, without solving
// for principal axes.
#pragma once

#include <cmath>

#include "particles/fields.hpp"
#include "shinohara2004/hooke_solid.hpp"

namespace kerf {

// Equivalent strain, 1, of a deviatoric stress s, Pa.
template <int D, class T>
KERF_FUNCTION T equivalent_strain(const SymmetricTensor<D, T>& s, T shear_modulus) {
  return std::sqrt(T(2) / T(3) * contract(s, s)) / (T(2) * shear_modulus);
}

// The fracture test at the end of a step. A particle that fails loses its deviatoric stress and
// bears compression only from then on. Its deviatoric energy is recorded as the fracture loss; its
// work against pressure stays in its pressure work.
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
