// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/equation_of_state.hpp"
#include "particles/fields.hpp"

namespace kerf {

// Sets the pressure from the density: all of it in fluids, that of the excess of K in nearly
// incompressible solids, zero in others.
template <int D, class P>
struct FluidPressure {
  using Real = typename P::Real;
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    const bool fluid = particles.is_fluid(i);
    particles.pressure[i] = particles.has_density(i)
                                ? medium.template share_by_density<Real>(fluid) *
                                      pressure_at(medium, particles.compression[i])
                                : Real(0);
  }
};

}  // namespace kerf
