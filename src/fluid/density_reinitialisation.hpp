// SPDX-License-Identifier: Apache-2.0
// DensityReinitialisation relaxes the density of water in motion to that of its particle
// concentration. The continuity equation integrates rates, and its density drifts from what the
// particles' positions imply: the pressure difference in U* diffuses density, and a particle that
// approaches a wall is compressed as by a mirror image that approaches it, while the particles of
// the wall stay. In a stagnation flow particles stay at the wall for long. So the density relaxes
// to
//   rho_0 phi / phi_0,   phi = sum V W,  phi_0 that of the lattice (fluid/lattice_sums.hpp),
// at a rate that follows the rearrangement of neighbours (fluid/particle_concentration.hpp):
// d rho/dt = max_relative_velocity (...). Not in a shock: phi is smoothed over 2 h there, and
// would take density away behind the front. Water at rest and sound waves are hardly affected, and
// a uniform motion changes nothing. The row of a free surface, where phi is too small for lack of
// neighbours, is left out; the density of the row beneath it relaxes to half a percent too little.
// Replacing the density by a sum over neighbours at intervals is common (Colagrossi & Landrini, J.
// Comput. Phys. 191 (2003) 448); the rate that follows the motion is this program's own.
#pragma once

#include "fluid/density_losses.hpp"
#include "fluid/particle_concentration.hpp"

namespace kerf {

template <int D, class P>
struct DensityReinitialisation {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  double dt;                           // s
  double lattice_kernel_sum;           // phi_0
  static constexpr double rate = 1.0;  // of `max_relative_velocity`; chosen: see docs/theory

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.medium(i).phase != Phase::water || particles.has(i, flag::upstream)) return;
    const Real kernel_sum = particles.kernel_sum[i];
    if (kernel_sum < Real(full_concentration)) return;
    const Real changes = rearrangement_rate(particles, i);
    if (!(changes > Real(0))) return;
    const Real part = Real(rate * dt) * changes;
    const Real gap = kernel_sum / Real(lattice_kernel_sum) - Real(1) - particles.compression[i];
    const Real before = particles.compression[i];
    particles.compression[i] += (part < Real(1) ? part : Real(1)) * gap;
    particles.reinitialisation_loss[i] -=
        stored_change(particles, i, before, particles.compression[i]);
  }
};

}  // namespace kerf
