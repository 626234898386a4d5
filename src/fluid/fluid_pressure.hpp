// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fluid/density_pressure.hpp"

namespace kerf {

// Sets the pressure from the density: all of it in fluids, that of the excess of K in nearly
// incompressible solids, zero in others.
template <int D, class P>
struct FluidPressure {
  using Real = typename P::Real;
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    particles.pressure[i] = particles.has_density(i)
                                ? pressure_by_density(particles, i, particles.compression[i])
                                : Real(0);
  }
};

}  // namespace kerf
