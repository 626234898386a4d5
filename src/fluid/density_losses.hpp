// SPDX-License-Identifier: Apache-2.0
// The energy that densities do not store of the work against pressure. The continuity equation with
// the Riemann solution moves each density by the velocity U*, which smooths the pressure
// (fluid/fluid_continuity.hpp), and density reinitialisation replaces densities
// (fluid/density_reinitialisation.hpp). Both are terms of the energy balance
// (docs/theory/balance.md).
#pragma once

#include "fluid/density_pressure.hpp"

namespace kerf {

// Returns the energy that particle i, which has a density, stores at the compression `after` less
// that at `before`, J/kg: the integral of p / rho^2 d rho by the midpoint rule, since the changes
// of a step are small, on either side of 0, where p(rho) may have a kink.
template <int D, class P>
KERF_FUNCTION typename P::Real stored_change(const ParticleView<D, P>& particles, Index i,
                                             typename P::Real before, typename P::Real after) {
  using Real = typename P::Real;
  const auto change = [&](Real from, Real to) {
    const Real middle = Real(0.5) * (from + to), ratio = Real(1) + middle;
    return pressure_by_density(particles, i, middle) /
           (particles.medium(i).density * ratio * ratio) * (to - from);
  };
  if ((before < Real(0)) == (after < Real(0))) return change(before, after);
  return change(before, Real(0)) + change(Real(0), after);
}

// The part of the work against pressure in a step that the continuity equation does not store; all
// of it where a particle has no density. It must come after KickAndDrift and FinalizeDensity
// (time/verlet.hpp), and before the density changes otherwise.
template <int D, class P>
struct ContinuityLoss {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  double dt;

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.medium(i).phase == Phase::rigid) return;
    particles.reinitialisation_loss[i] = Real(0);
    const Real stored =
        particles.has_density(i)
            ? stored_change(particles, i, particles.start_compression[i], particles.compression[i])
            : Real(0);
    particles.continuity_loss[i] = Real(dt) * particles.pressure_power[i] - stored;
  }
};

}  // namespace kerf
