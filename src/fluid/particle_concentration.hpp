// SPDX-License-Identifier: Apache-2.0
// ParticleConcentration sums the kernel around a particle,
//   phi_i = sum_j V_0j W_ij,   over its neighbours and itself,
// which is 1 inside a medium at its rest density and about 1/2 at a flat surface. The continuity
// equation integrates rates, independently of the particles' positions: a medium that separated
// without pressure may keep its low density although its particles are close again, and others
// would penetrate it. So the density of an expanded medium is not below rho_0 phi
// (time/verlet.hpp), and that of water in motion relaxes to it
// (fluid/density_reinitialisation.hpp). A compressed medium of another phase counts with the volume
// of its density, V_0j rho_0j / rho_j: compressed foam yields to water that enters it. The term
// also computes the max relative velocity of the fluid neighbours, |v_ij| / h.
#pragma once

#include <cmath>

#include "fluid/known_sums.hpp"
#include "fluid/smooth_wall.hpp"
#include "pairs/pair.hpp"

namespace kerf {

// With a larger phi a particle lacks no neighbours: it is not in a free surface.
inline constexpr double full_concentration = 0.95;

// Returns the rate at which the neighbours of a water particle change their places, 1/s: its
// `max_relative_velocity` without the part of waves. A plane wave with the strain rate
// u' = - div v moves neighbours relative to one another at up to 2 u' h.
template <int D, class P>
KERF_FUNCTION typename P::Real rearrangement_rate(const ParticleView<D, P>& particles, Index i) {
  using Real = typename P::Real;
  const Real compressing = particles.compression_rate[i] / (Real(1) + particles.compression[i]);
  const Real rate = particles.max_relative_velocity[i] - Real(2) * std::abs(compressing);
  return rate > Real(0) ? rate : Real(0);
}

template <int D, class P, class Kernel>
struct ParticleConcentration {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Real kernel_sum{};
    Real fastest_squared{};  // m^2/s^2
  };
  KnownSums<D, Real> known{};

  KERF_FUNCTION void start(const ParticleView<D, P>& particles, Index i, Sum& sum) const {
    if (!known.are_known()) return;
    sum.kernel_sum = known[i].kernel_sum();
    if (particles.is_fluid(i)) sum.fastest_squared = known[i].fastest_squared;
  }
  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!particles.has_density(pair.i)) return;
    sum.kernel_sum +=
        counted_volume(particles, pair) * Kernel::value(pair.distance, pair.smoothing_length);
    if (!particles.is_fluid(pair.j)) return;
    const Real squared = dot(pair.velocity, pair.velocity);
    if (squared > sum.fastest_squared) sum.fastest_squared = squared;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    particles.kernel_sum[i] =
        sum.kernel_sum + medium.volume * Kernel::value(Real(0), Real(medium.smoothing_length));
    particles.max_relative_velocity[i] = std::sqrt(sum.fastest_squared) / medium.smoothing_length;
  }

 private:
  KERF_FUNCTION static Real counted_volume(const ParticleView<D, P>& particles,
                                           const Pair<D, P>& pair) {
    const Real at_rest = pair.medium_j->volume;
    if (is_at_smooth_wall(particles, pair)) return wall_volume_factor(particles, pair.i) * at_rest;
    if (pair.medium_i->phase == pair.medium_j->phase) return at_rest;
    const Real current = volume_of(particles, pair.j, *pair.medium_j);
    return current < at_rest ? current : at_rest;
  }
};

}  // namespace kerf
