// SPDX-License-Identifier: Apache-2.0
// Stress of each particle from its state: pressure by the equation of state, eqs. (15) and (32),
// and for water the viscous stress mu V, eqs. (28) to (31),
//   V = grad v + (grad v)^T - (2/3) div v.
#pragma once

#include "materials/tait.hpp"
#include "particles/fields.hpp"
#include "shinohara2004/hooke_solid.hpp"

namespace kerf {

template <int D, class P>
struct UpdateStress {
  using Real = typename P::Real;
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    const Real compression = particles.compression[i];
    if (medium.phase == Phase::water) {
      particles.pressure[i] = medium.tait.pressure(medium, compression);
      particles.shear[i] = viscous_stress(medium.viscosity, particles.velocity_gradient[i]);
    } else if (medium.phase == Phase::solid) {
      particles.pressure[i] =
          HookeSolid::pressure(medium, compression, particles.fractured[i] != 0);
    } else {
      particles.pressure[i] = Real(0);
    }
  }

 private:
  KERF_FUNCTION static SymmetricTensor<D, Real> viscous_stress(Real viscosity,
                                                               const Matrix<D, Real>& gradient) {
    auto stress = SymmetricTensor<D, Real>::zero();
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) stress(a, b) = viscosity * (gradient(a, b) + gradient(b, a));
    const Real mean = viscosity * Real(2) / Real(3) * gradient.trace();
    for (int a = 0; a < 3; ++a) stress(a, a) -= mean;
    return stress;
  }
};

}  // namespace kerf
